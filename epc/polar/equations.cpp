#include "epc/polar/equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "epc/moment/energy_domain.hpp"
#include "epc/polar/graded_impulse_rule.hpp"

namespace fpkcheck::epc::polar {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// E[phi(y, v + Y)] of every member at every point.
MatrixXd after_impulse(const problem::Problem& problem, const Coordinates& coordinates,
                       const moment::Basis& basis, const Points& points) {
  GradedImpulseRule rule(problem.impulses.law());
  MatrixXd result(points.y.size(), basis.size());
  for (Index i = 0; i < points.y.size(); ++i) {
    const double w = coordinates.w(points.y[i]);
    const AfterImpulse& after = rule(points.v[i], w);
    const auto count = static_cast<Index>(after.v.size());
    VectorXd rho(count), theta(count);
    for (Index k = 0; k < count; ++k) {
      rho[k] = std::sqrt(w * w + after.v[k] * after.v[k]);
      theta[k] = std::atan2(after.v[k], w);
    }
    const Eigen::Map<const VectorXd> probability(after.probability.data(), count);
    const MatrixXd products = basis.of_y().values(rho).transpose() * probability.asDiagonal() *
                              basis.of_v().values(theta);
    for (Index s = 0; s < basis.size(); ++s) {
      const auto& [p, q] = basis.members()[s];
      result(i, s) = products(p, q);
    }
  }
  return result;
}

moment::GalerkinTables tables(const problem::Problem& problem, const Coordinates& coordinates,
                              double rho_max, const moment::Confinement& confinement,
                              const moment::Basis& basis, const Points& points, int wall_points) {
  const double c = problem.system.damping();
  const auto& [rho, theta, y, v, weight] = points;
  VectorXd rho_rate(rho.size()), theta_rate(rho.size());
  for (Index i = 0; i < rho.size(); ++i) {
    const double sine = std::sin(theta[i]), cosine = std::cos(theta[i]);
    const double slope = coordinates.slope(y[i]), force = coordinates.force_by_w(y[i]);
    const double w = rho[i] * cosine;
    rho_rate[i] = -c * rho[i] * sine * sine + w * (slope - force) * sine;
    theta_rate[i] = -slope * sine * sine - force * cosine * cosine - c * sine * cosine;
  }
  const auto of_rho = basis.of_y().derivatives(rho, 1);
  const auto of_theta = basis.of_v().derivatives(theta, 1);
  const auto& members = basis.members();
  const MatrixXd values = moment::products(members, of_rho[0], of_theta[0]);
  const double rate = problem.impulses.arrival_rate();

  const moment::Line wall = moment::legendre_rule(wall_points, 0, rho_max);
  const VectorXd before = VectorXd::Constant(wall_points, -std::numbers::pi / 2);
  const VectorXd kept = problem.system.restitution() * wall.at;
  const MatrixXd wall_members = basis.values(wall.at, before);
  const auto confined_at = [&](double r) { return confined(confinement, r); };
  return {.weight = weight,
          .members = values,
          .generated = moment::products(members, rho_rate.asDiagonal() * of_rho[1], of_theta[0]) +
                       moment::products(members, of_rho[0], theta_rate.asDiagonal() * of_theta[1]) +
                       rate * (after_impulse(problem, coordinates, basis, points) - values),
          .confined = rho.unaryExpr(confined_at),
          .wall_weight = wall.weight,
          .wall_members = wall_members,
          .rebounds = wall.at.asDiagonal() * (basis.values(kept, -before) - wall_members),
          .wall_confined = wall.at.unaryExpr(confined_at)};
}

}  // namespace

Equations::Equations(const problem::Problem& problem, const Coordinates& coordinates,
                     double rho_max, const moment::Confinement& confinement, moment::Basis basis,
                     const QuadratureSize& size)
    : Equations(problem, coordinates, rho_max, confinement, std::move(basis),
                rule(coordinates, rho_max, breaks_of(problem.impulses.law(), rho_max), size),
                size.rho) {}

Equations::Equations(const problem::Problem& problem, const Coordinates& coordinates,
                     double rho_max, const moment::Confinement& confinement, moment::Basis basis,
                     Points points, int wall_points)
    : Galerkin(tables(problem, coordinates, rho_max, confinement, basis, points, wall_points)),
      basis_(std::move(basis)),
      points_(std::move(points)) {}

std::vector<double> breaks_of(const problem::ImpulseLaw& law, double rho_max) {
  std::vector<double> breaks;
  for (const auto& atom : law.atoms()) {
    const double at = std::abs(atom.amplitude);
    if (at > 0 && at < rho_max) breaks.push_back(at);
  }
  std::ranges::sort(breaks);
  // Atoms at -a and a are one break, up to rounding.
  const auto near = [](double a, double b) { return b - a < 1e-9 * b; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), near), breaks.end());
  return breaks;
}

moment::Basis basis_of(int order, const Points& points, const VectorXd& mass) {
  return {order, {points.rho, points.theta, points.weight}, mass};
}

}  // namespace fpkcheck::epc::polar
