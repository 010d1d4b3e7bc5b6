#pragma once

#include <vector>

#include "backward/generator/velocity_pieces.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::backward {

/// K B_b, (K V)(v) = E[V(v + Y)], of every function of an ImpactBasis on every piece of the
/// velocity axis, as polynomials with enclosed Bernstein coefficients of t = (v - from)/(to -
/// from).
struct ImpulseTable {
  int functions = 0, order = 0;  ///< order: coefficients of a polynomial, its degree + 1
  std::vector<numerics::Interval> coefficients;  ///< shape (pieces, functions, order)
  /// |K V - sum_b c_b (polynomial of b)| <= remainder max_b |c_b|, everywhere.
  double remainder = 0;

  std::span<numerics::Interval> of(int piece, int function) {
    return {&coefficients[(static_cast<std::size_t>(piece) * functions + function) * order],
            static_cast<std::size_t>(order)};
  }
  std::span<const numerics::Interval> of(int piece, int function) const {
    return {&coefficients[(static_cast<std::size_t>(piece) * functions + function) * order],
            static_cast<std::size_t>(order)};
  }
};

/// Whether tables and moments of this law are known with enclosures: of what follows a law for
/// which they are not is no argument.
bool has_enclosures(const problem::ImpulseLaw& law);

/// What the pieces must respect for a table of this law.
struct ImpulseKinks {
  double longest;            ///< no piece may be longer
  std::vector<double> cuts;  ///< where K B is not smooth besides the breaks of the basis
};
ImpulseKinks impulse_kinks(const ImpactBasis& basis, const problem::ImpulseLaw& law);

/// The table of a law on pieces made with `impulse_kinks`.
ImpulseTable impulse_table(const ImpactBasis& basis, const std::vector<VelocityPiece>& pieces,
                           const problem::ImpulseLaw& law);

/// E[Y^n], from the stored parameters of the law.
numerics::Interval moment_enclosure(const problem::ImpulseLaw& law, int n);

// The laws' own tables; see the sources. A law that has none has no bounds.
ImpulseTable table_of(const problem::ExponentialLaw& law, const ImpactBasis& basis,
                      const std::vector<VelocityPiece>& pieces);
ImpulseTable table_of(const problem::GaussianLaw& law, const ImpactBasis& basis,
                      const std::vector<VelocityPiece>& pieces);
ImpulseTable table_of(const problem::LaplaceLaw& law, const ImpactBasis& basis,
                      const std::vector<VelocityPiece>& pieces);
ImpulseTable table_of(const problem::TwoPointLaw& law, const ImpactBasis& basis,
                      const std::vector<VelocityPiece>& pieces);
ImpulseTable table_of(const problem::UniformLaw& law, const ImpactBasis& basis,
                      const std::vector<VelocityPiece>& pieces);

/// A table of zeros.
ImpulseTable empty_table(const ImpactBasis& basis, const std::vector<VelocityPiece>& pieces,
                         int order);

}  // namespace fpkcheck::backward
