#include "backward/residual/spline_fractions.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include "base/input_error.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::backward {

Eigen::MatrixXd spline_fractions(const numerics::QuinticBSplines& splines,
                                 std::span<const double> edges) {
  if (edges.size() < 2 ||
      std::ranges::adjacent_find(edges, std::greater_equal<>()) != edges.end()) {
    throw InputError("the cell edges of a map do not increase");
  }
  // Between breaks and edges the splines are polynomials of degree 5, for which three Gauss points
  // are exact.
  std::vector<double> cuts(splines.breaks());
  std::ranges::copy_if(edges, std::back_inserter(cuts),
                       [&](double x) { return splines.begin() < x && x < splines.end(); });
  std::ranges::sort(cuts);
  Eigen::MatrixXd fractions = Eigen::MatrixXd::Zero(std::ssize(edges) - 1, splines.size());
  const auto [points, weights] = numerics::composite_gauss_rule<3>(cuts);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto cell = std::ranges::upper_bound(edges, points[n]) - edges.begin() - 1;
    if (cell < 0 || cell >= fractions.rows()) continue;
    const auto b = splines.values_and_slopes(points[n]);
    for (int l = 0; l <= numerics::QuinticBSplines::kDegree; ++l) {
      fractions(cell, b.first + l) += weights(static_cast<Eigen::Index>(n)) * b.value[l];
    }
  }
  // The integral of a B-spline is the width of its support divided by its degree plus 1 (de Boor).
  for (int i = 0; i < splines.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& knots = splines.knots();
    fractions.col(i) *= (numerics::QuinticBSplines::kDegree + 1) /
                        (knots[k + numerics::QuinticBSplines::kDegree + 1] - knots[k]);
  }
  return fractions;
}

}  // namespace fpkcheck::backward
