#include "dual/residual/spline_shares.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <functional>
#include <vector>

#include "parameters/input_error.hpp"

namespace fpkcheck::dual {

Eigen::MatrixXd spline_shares(const KnotSplines& splines, std::span<const double> edges) {
  if (edges.size() < 2 ||
      std::ranges::adjacent_find(edges, std::greater_equal<>()) != edges.end()) {
    throw InputError("the edges of the cells of a map must increase");
  }
  // Between all breaks and edges splines are polynomials of degree 5: three points are exact.
  using Gauss = boost::math::quadrature::gauss<double, 3>;
  std::vector<double> cuts(splines.breaks());
  std::ranges::copy_if(edges, std::back_inserter(cuts),
                       [&](double x) { return splines.begin() < x && x < splines.end(); });
  std::ranges::sort(cuts);
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(std::ssize(edges) - 1, splines.size());
  for (std::size_t part = 0; part + 1 < cuts.size(); ++part) {
    const double centre = (cuts[part] + cuts[part + 1]) / 2;
    const double half = (cuts[part + 1] - cuts[part]) / 2;
    const auto cell = std::ranges::upper_bound(edges, centre) - edges.begin() - 1;
    if (cell < 0 || cell >= shares.rows()) continue;
    for (std::size_t n = 0; n < Gauss::abscissa().size(); ++n) {
      for (const double sign : {-1.0, 1.0}) {
        if (sign < 0 && Gauss::abscissa()[n] == 0) continue;
        const auto b = splines.at(centre + sign * half * Gauss::abscissa()[n]);
        for (int l = 0; l <= KnotSplines::kDegree; ++l) {
          shares(cell, b.first + l) += half * Gauss::weights()[n] * b.value[l];
        }
      }
    }
  }
  // The integral of a spline is the width of its support by its degree plus 1 (de Boor).
  for (int i = 0; i < splines.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& knots = splines.knots();
    shares.col(i) *= (KnotSplines::kDegree + 1) / (knots[k + KnotSplines::kDegree + 1] - knots[k]);
  }
  return shares;
}

}  // namespace fpkcheck::dual
