#include "epc/moment/equations.hpp"

#include <boost/math/special_functions/factorials.hpp>
#include <utility>

#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::products;

namespace {

// f + g, damping plus restoring force.
VectorXd force_at(const problem::System& system, const VectorXd& y, const VectorXd& v) {
  if (system.damping_is_constant()) return system.damping() * v + y.unaryExpr(system.force());
  const VectorXd damping =
      y.unaryExpr(system.damping_polynomial()).array() + system.rayleigh() * v.array().square();
  return damping.cwiseProduct(v) + y.unaryExpr(system.force());
}

// Quadrature points on all walls: y, and v before and after the impact.
struct Incoming {
  VectorXd y, before, after, weight;

  void add(const problem::Wall& wall, const half_plane::Line& line) {
    const auto joined = [](const VectorXd& a, const VectorXd& b) {
      VectorXd both(a.size() + b.size());
      both << a, b;
      return both;
    };
    y = joined(y, VectorXd::Constant(line.at.size(), wall.position));
    before = joined(before, line.at);
    after = joined(after, -wall.restitution * line.at);
    weight = joined(weight, line.weight);
  }
};

Incoming incoming(const problem::System& system, const EnergyDomain& domain, int points) {
  Incoming all;
  if (system.left()) all.add(*system.left(), domain.wall_rule(points));
  if (system.right()) all.add(*system.right(), domain.right_wall_rule(points));
  return all;
}

}  // namespace

half_plane::Equations equations(const problem::Problem& problem,
                                const std::vector<double>& rate_moment, const EnergyDomain& domain,
                                const half_plane::Confinement& confinement, half_plane::Basis basis,
                                half_plane::Points points, int wall_points) {
  const auto& system = problem.system;
  const int n = basis.order();
  const VectorXd &y = points.y, &v = points.v;
  const auto of_y = basis.of_s().derivatives(y, 1);
  const auto of_v = basis.of_t().derivatives(v, n);

  // L* h_p(y) g_q(v) = v h_p' g_q + h_p [ -(f + g) g_q' + sum_j .. g_q^(j) ]. White noise beside
  // the impulses adds its intensity 2D to lambda E[Y^2]: D = 2D/2!.
  MatrixXd impulses = MatrixXd::Zero(v.size(), n + 1);
  for (int j = 1; j <= n; ++j) {
    const double intensity = j == 2 ? problem.noise.intensity : 0;
    const double factor =
        (rate_moment[j] + intensity) / boost::math::factorial<double>(static_cast<unsigned>(j));
    if (factor != 0) impulses += factor * of_v[j];
  }
  const VectorXd force = force_at(system, y, v);

  const Incoming wall = incoming(system, domain, wall_points);
  const MatrixXd wall_members = basis.values(wall.y, wall.before);
  half_plane::GalerkinTables tables{
      .weight = points.weight,
      .members = products(basis.members(), of_y[0], of_v[0]),
      .generated = products(basis.members(), v.asDiagonal() * of_y[1], of_v[0]) +
                   products(basis.members(), of_y[0], impulses - force.asDiagonal() * of_v[1]),
      .confined = points.energy.unaryExpr(confinement),
      .wall_weight = wall.weight,
      .wall_members = wall_members,
      .rebounds =
          wall.before.cwiseAbs().asDiagonal() * (basis.values(wall.y, wall.after) - wall_members),
      .wall_confined = VectorXd::NullaryExpr(wall.y.size(), [&](Eigen::Index i) {
        return confinement(domain.energy(wall.y[i], wall.before[i]));
      })};
  return {std::move(tables), std::move(basis), std::move(points)};
}

}  // namespace fpkcheck::epc::moment
