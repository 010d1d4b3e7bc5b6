#include "epc/half_plane/quadrature_points.hpp"

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <vector>

namespace fpkcheck::epc::half_plane {

QuadraturePoints QuadraturePoints::zeros(Eigen::Index count) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(count);
  return {.s = zero, .t = zero, .y = zero, .v = zero, .energy = zero, .weight = zero};
}

QuadratureRule legendre_rule(int points, double a, double b) {
  std::vector<double> nodes;
  for (const double zero : boost::math::legendre_p_zeros<double>(points)) {
    if (zero > 0) nodes.push_back(-zero);
    nodes.push_back(zero);
  }
  std::ranges::sort(nodes);
  QuadratureRule line{Eigen::VectorXd(points), Eigen::VectorXd(points)};
  for (int i = 0; i < points; ++i) {
    const double x = nodes[i];
    const double slope = boost::math::legendre_p_prime(points, x);
    line.at[i] = (a + b) / 2 + (b - a) / 2 * x;
    line.weight[i] = (b - a) / ((1 - x * x) * slope * slope);
  }
  return line;
}

}  // namespace fpkcheck::epc::half_plane
