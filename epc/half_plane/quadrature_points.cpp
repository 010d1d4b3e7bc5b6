#include "epc/half_plane/quadrature_points.hpp"

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <vector>

namespace fpkcheck::epc::half_plane {

QuadraturePoints QuadraturePoints::zeros(Eigen::Index count) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(count);
  return {.s = zero, .t = zero, .y = zero, .v = zero, .energy = zero, .weight = zero};
}

QuadratureRule gauss_legendre_rule(int point_count, double from, double to) {
  std::vector<double> nodes;
  for (const double zero : boost::math::legendre_p_zeros<double>(point_count)) {
    if (zero > 0) nodes.push_back(-zero);
    nodes.push_back(zero);
  }
  std::ranges::sort(nodes);
  QuadratureRule line{Eigen::VectorXd(point_count), Eigen::VectorXd(point_count)};
  for (int i = 0; i < point_count; ++i) {
    const double x = nodes[i];
    const double slope = boost::math::legendre_p_prime(point_count, x);
    line.nodes[i] = (from + to) / 2 + (to - from) / 2 * x;
    line.weight[i] = (to - from) / ((1 - x * x) * slope * slope);
  }
  return line;
}

}  // namespace fpkcheck::epc::half_plane
