#include "dual/backward/difference_slopes.hpp"

#include "dual/spline/bezier.hpp"

namespace fpkcheck::dual {

std::vector<Coefficients> difference_slopes(const SplineBasis& basis, int span,
                                            const Interval& from, const Interval& to) {
  const int p = basis.degree();
  const SplineBasis lower({basis.breaks().begin(), basis.breaks().end()}, p - 1);
  const auto rows = bezier_rows<Interval>(lower, span, from, to);
  std::vector<Coefficients> slopes;
  for (int l = 1; l <= p; ++l) {
    const Interval distance = Interval(basis.knot(span + l + p)) - basis.knot(span + l);
    Coefficients slope(rows.row(l - 1).begin(), rows.row(l - 1).end());
    for (Interval& s : slope) s *= static_cast<double>(p) / distance;
    slopes.push_back(std::move(slope));
  }
  return slopes;
}

}  // namespace fpkcheck::dual
