#include "epc/moment/equations.hpp"

#include <boost/math/special_functions/factorials.hpp>
#include <utility>

namespace fpkcheck::epc::moment {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

GalerkinTables tables(const problem::Problem& problem, const std::vector<double>& rate_moment,
                      const EnergyDomain& domain, const Confinement& confinement,
                      const Basis& basis, const Points& inside, const Points& wall) {
  const auto& system = problem.system;
  const int n = basis.order();
  const auto& [y, v, weight] = inside;
  const auto of_y = basis.of_y().derivatives(y, 1);
  const auto of_v = basis.of_v().derivatives(v, n);

  // L* on h_p(y) g_q(v) = v h_p' g_q + h_p [ -(c v + k y + mu y^3) g_q' + sum_j .. g_q^(j) ]
  MatrixXd impulses = MatrixXd::Zero(v.size(), n + 1);
  for (int j = 1; j <= n; ++j) {
    const double factor = rate_moment[j] / boost::math::factorial<double>(static_cast<unsigned>(j));
    if (factor != 0) impulses += factor * of_v[j];
  }
  const VectorXd force = system.damping() * v.array() + system.stiffness() * y.array() +
                         system.cubic() * y.array().cube();
  const auto confined = [&](const Points& points) {
    VectorXd term(points.y.size());
    for (Eigen::Index i = 0; i < term.size(); ++i) {
      term[i] = confinement(domain.energy(points.y[i], points.v[i]));
    }
    return term;
  };
  const MatrixXd wall_members = basis.values(wall.y, wall.v);
  const VectorXd after = -system.restitution() * wall.v;
  return {.weight = weight,
          .members = products(basis.members(), of_y[0], of_v[0]),
          .generated = products(basis.members(), v.asDiagonal() * of_y[1], of_v[0]) +
                       products(basis.members(), of_y[0], impulses - force.asDiagonal() * of_v[1]),
          .confined = confined(inside),
          .wall_weight = wall.weight,
          .wall_members = wall_members,
          .rebounds = (-wall.v).asDiagonal() * (basis.values(wall.y, after) - wall_members),
          .wall_confined = confined(wall)};
}

}  // namespace

Equations::Equations(const problem::Problem& problem, const std::vector<double>& rate_moment,
                     const EnergyDomain& domain, const Confinement& confinement, Basis basis,
                     const QuadratureSize& size)
    : Equations(problem, rate_moment, domain, confinement, std::move(basis),
                domain.rule(size.y, size.v), domain.wall_rule(size.wall)) {}

Equations::Equations(const problem::Problem& problem, const std::vector<double>& rate_moment,
                     const EnergyDomain& domain, const Confinement& confinement, Basis basis,
                     const Points& inside, const Points& wall)
    : Galerkin(tables(problem, rate_moment, domain, confinement, basis, inside, wall)),
      basis_(std::move(basis)),
      inside_(inside) {}

}  // namespace fpkcheck::epc::moment
