// Y = m -+ s, each with probability 1/2: K B(v) = (B(v + m - s) + B(v + m + s)) / 2, a polynomial
// on pieces cut where v + m -+ s meets a break.
#include "backward/generator/impulse_table.hpp"

namespace fpkcheck::backward {

ImpulseTable impulse_table_of_law(const problem::TwoPointLaw& law, const ImpactBasis& basis,
                                  const std::vector<VelocityPiece>& pieces) {
  const int order = basis.speeds().degree() + 2;  // order of the term v V_y of the generator
  ImpulseTable table = zero_impulse_table(basis, pieces, order);
  double overhang = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const numerics::Interval shift = numerics::Interval(law.mean) + sign * law.deviation;
      const BasisFunctionsOnPiece there = basis_functions_on_piece(
          basis, velocity_piece_of_segment(basis, pieces[i].from + shift, pieces[i].to + shift));
      overhang = std::max(overhang, there.overhang_error);
      for (std::size_t l = 0; l < there.index.size(); ++l) {
        const numerics::BernsteinCoefficients b = elevate_degree(there.value[l], order - 1);
        const std::span<numerics::Interval> out =
            table.coefficients_of(static_cast<int>(i), there.index[l]);
        for (int j = 0; j < order; ++j) out[j] += b[j] / 2.0;
      }
    }
  }
  // At a point the error affects at most the functions of two spans, 2 (p + 1).
  table.remainder = (2.0 * (basis.speeds().degree() + 1.0) * numerics::Interval(overhang)).upper();
  return table;
}

}  // namespace fpkcheck::backward
