#include "backward/generator/partial_sum_slopes.hpp"

#include "numerics/splines/bezier_extraction.hpp"

namespace fpkcheck::backward {

std::vector<numerics::BernsteinCoefficients> partial_sum_slopes(const numerics::SplineBasis& basis,
                                                                int span,
                                                                const numerics::Interval& from,
                                                                const numerics::Interval& to) {
  const int p = basis.degree();
  const numerics::SplineBasis lower({basis.breaks().begin(), basis.breaks().end()}, p - 1);
  const auto rows = numerics::bezier_extraction<numerics::Interval>(lower, span, from, to);
  std::vector<numerics::BernsteinCoefficients> slopes;
  for (int l = 1; l <= p; ++l) {
    const numerics::Interval distance =
        numerics::Interval(basis.knot(span + l + p)) - basis.knot(span + l);
    numerics::BernsteinCoefficients slope(rows.row(l - 1).begin(), rows.row(l - 1).end());
    for (numerics::Interval& s : slope) s *= static_cast<double>(p) / distance;
    slopes.push_back(std::move(slope));
  }
  return slopes;
}

}  // namespace fpkcheck::backward
