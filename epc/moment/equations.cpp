#include "epc/moment/equations.hpp"

#include <boost/math/special_functions/factorials.hpp>
#include <utility>

#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::products;

half_plane::Equations equations(const problem::Problem& problem,
                                const std::vector<double>& rate_moment, const EnergyDomain& domain,
                                const half_plane::Confinement& confinement, half_plane::Basis basis,
                                half_plane::Points points, int wall_points) {
  const auto& system = problem.system;
  const int n = basis.order();
  const VectorXd &y = points.y, &v = points.v;
  const auto of_y = basis.of_s().derivatives(y, 1);
  const auto of_v = basis.of_t().derivatives(v, n);

  // L* on h_p(y) g_q(v) = v h_p' g_q + h_p [ -(c v + g(y)) g_q' + sum_j .. g_q^(j) ]
  MatrixXd impulses = MatrixXd::Zero(v.size(), n + 1);
  for (int j = 1; j <= n; ++j) {
    const double factor = rate_moment[j] / boost::math::factorial<double>(static_cast<unsigned>(j));
    if (factor != 0) impulses += factor * of_v[j];
  }
  const VectorXd force = system.damping() * v + y.unaryExpr(system.force());

  const half_plane::Line wall = domain.wall_rule(wall_points);
  const VectorXd at_wall = VectorXd::Zero(wall.at.size());
  const VectorXd after = -system.restitution() * wall.at;
  const MatrixXd wall_members = basis.values(at_wall, wall.at);
  half_plane::GalerkinTables tables{
      .weight = points.weight,
      .members = products(basis.members(), of_y[0], of_v[0]),
      .generated = products(basis.members(), v.asDiagonal() * of_y[1], of_v[0]) +
                   products(basis.members(), of_y[0], impulses - force.asDiagonal() * of_v[1]),
      .confined = points.energy.unaryExpr(confinement),
      .wall_weight = wall.weight,
      .wall_members = wall_members,
      .rebounds = (-wall.at).asDiagonal() * (basis.values(at_wall, after) - wall_members),
      .wall_confined =
          wall.at.unaryExpr([&](double v_in) { return confinement(domain.energy(0, v_in)); })};
  return {std::move(tables), std::move(basis), std::move(points)};
}

}  // namespace fpkcheck::epc::moment
