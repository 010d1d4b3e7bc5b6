#pragma once

#include <vector>

#include "backward/generator/impact_basis.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::backward {

/// Table of the means K B_b of the basis functions B_b after an impulse, (K V)(v) = E[V(v + Y)],
/// for every function of an ImpactBasis on every piece of the velocity axis. Each element is a
/// polynomial of t = (v - from)/(to - from) with enclosed Bernstein coefficients.
struct ImpulseMeanTable {
  /// `order` is the number of coefficients of a polynomial, degree + 1
  int functions = 0, order = 0;
  std::vector<numerics::Interval> coefficients;  ///< shape (pieces, functions, order)
  /// Relative error bound: |K V - sum_b c_b (polynomial of b)| <= remainder max_b |c_b| for all v
  double remainder = 0;

  std::span<numerics::Interval> coefficients_of(int piece, int function) {
    return {&coefficients[(static_cast<std::size_t>(piece) * functions + function) * order],
            static_cast<std::size_t>(order)};
  }
  std::span<const numerics::Interval> coefficients_of(int piece, int function) const {
    return {&coefficients[(static_cast<std::size_t>(piece) * functions + function) * order],
            static_cast<std::size_t>(order)};
  }
};

/// Returns whether the impulse table and the moments of a law have interval enclosures. All other
/// functions of impulse_mean_table.hpp require a law with interval enclosures.
bool has_interval_enclosures(const problem::ImpulseLaw& law);

struct VelocityPieceConstraints {
  double longest;            ///< largest permitted length of a piece
  std::vector<double> cuts;  ///< velocities, besides breaks of the basis, where K B is not smooth
};
VelocityPieceConstraints velocity_piece_constraints(const ImpactBasis& basis,
                                                    const problem::ImpulseLaw& law);

/// Returns the impulse table of a law on pieces that satisfy velocity_piece_constraints().
ImpulseMeanTable impulse_mean_table(const ImpactBasis& basis,
                                    const std::vector<VelocityPiece>& pieces,
                                    const problem::ImpulseLaw& law);

/// Returns an enclosure of E[Y^n], computed from the stored parameters of the law.
numerics::Interval moment_enclosure(const problem::ImpulseLaw& law, int n);

// A law without an impulse table has no guaranteed bounds.
ImpulseMeanTable impulse_mean_table_of_law(const problem::ExponentialLaw& law,
                                           const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces);
ImpulseMeanTable impulse_mean_table_of_law(const problem::GaussianLaw& law,
                                           const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces);
ImpulseMeanTable impulse_mean_table_of_law(const problem::LaplaceLaw& law, const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces);
ImpulseMeanTable impulse_mean_table_of_law(const problem::TwoPointLaw& law,
                                           const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces);
ImpulseMeanTable impulse_mean_table_of_law(const problem::UniformLaw& law, const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces);

ImpulseMeanTable zero_impulse_mean_table(const ImpactBasis& basis,
                                         const std::vector<VelocityPiece>& pieces, int order);

}  // namespace fpkcheck::backward
