#include "epc/polar/equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "epc/amplitude/half_circle.hpp"
#include "epc/amplitude/means_after_impulse.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::polar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::Basis;
using half_plane::products_of_tables;
using half_plane::QuadraturePoints;

// Means E[phi(y, v + Y)] of every basis function at every point.
MatrixXd means_of_basis_after_impulse(const problem::Problem& problem,
                                      const Coordinates& coordinates, const Basis& basis,
                                      const QuadraturePoints& points) {
  const VectorXd w = points.y.unaryExpr([&](double y) { return coordinates.potential_speed(y); });
  return amplitude::means_after_impulse(
      problem.impulses.law(), basis, w, points.v, [](double at_w, double v) {
        return std::pair{std::sqrt(at_w * at_w + v * v), std::atan2(v, at_w)};
      });
}

// Rates of change rho' and theta' between impulses.
struct FlowRates {
  VectorXd rho, theta;
};
FlowRates flow_rates(double damping, const Coordinates& coordinates,
                     const QuadraturePoints& points) {
  FlowRates rate{VectorXd(points.size()), VectorXd(points.size())};
  for (Index i = 0; i < points.size(); ++i) {
    const double rho = points.s[i], theta = points.t[i];
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const double slope = coordinates.potential_speed_slope(points.y[i]);
    const double force = coordinates.force_over_potential_speed(points.y[i]);
    rate.rho[i] = -damping * rho * sine * sine + rho * cosine * (slope - force) * sine;
    rate.theta[i] = -slope * sine * sine - force * cosine * cosine - damping * sine * cosine;
  }
  return rate;
}

}  // namespace

half_plane::ClosureEquations closure_equations(const problem::Problem& problem,
                                               const Coordinates& coordinates, double rho_max,
                                               const half_plane::Confinement& confinement,
                                               Basis basis, QuadraturePoints points,
                                               int wall_points) {
  const FlowRates rate = flow_rates(problem.system.damping(), coordinates, points);
  const auto rho_tables = basis.polynomials_in_s().derivative_tables(points.s, 1);
  const auto theta_tables = basis.polynomials_in_t().derivative_tables(points.t, 1);
  const auto& members = basis.members();
  const MatrixXd values = products_of_tables(members, rho_tables[0], theta_tables[0]);
  const double arrivals = problem.impulses.arrival_rate();

  const half_plane::QuadratureRule wall = half_plane::gauss_legendre_rule(wall_points, 0, rho_max);
  const VectorXd before = VectorXd::Constant(wall_points, -std::numbers::pi / 2);
  const VectorXd rebound_speed = problem.system.restitution() * wall.nodes;
  const MatrixXd wall_members = basis.basis_values(wall.nodes, before);
  half_plane::GalerkinTables tables{
      .weight = points.weight,
      .members = values,
      .generator_terms =
          products_of_tables(members, rate.rho.asDiagonal() * rho_tables[1], theta_tables[0]) +
          products_of_tables(members, rho_tables[0], rate.theta.asDiagonal() * theta_tables[1]) +
          arrivals * (means_of_basis_after_impulse(problem, coordinates, basis, points) - values),
      .confinement_terms = points.energy.unaryExpr(confinement),
      .wall_weight = wall.weight,
      .wall_members = wall_members,
      .impact_terms =
          wall.nodes.asDiagonal() * (basis.basis_values(rebound_speed, -before) - wall_members),
      .wall_confinement_terms = wall.nodes.unaryExpr(
          [&](double rho) { return confinement(amplitude::energy_of_amplitude(rho)); })};
  return {std::move(tables), std::move(basis), std::move(points)};
}

std::vector<double> amplitude_break_points(const problem::ImpulseLaw& law, double rho_max) {
  std::vector<double> breaks;
  for (const auto& atom : law.atoms()) {
    const double at = std::abs(atom.amplitude);
    if (at > 0 && at < rho_max) breaks.push_back(at);
  }
  std::ranges::sort(breaks);
  // The atoms at -a and a give the same amplitude, up to rounding.
  const auto near = [](double a, double b) { return b - a < 1e-9 * b; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), near), breaks.end());
  return breaks;
}

}  // namespace fpkcheck::epc::polar
