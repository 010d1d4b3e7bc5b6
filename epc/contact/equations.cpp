#include "epc/contact/equations.hpp"

#include <utility>

#include "epc/amplitude/half_circle.hpp"
#include "epc/amplitude/means_after_impulse.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::Basis;
using half_plane::products_of_tables;
using half_plane::QuadraturePoints;

// Means E[phi(y, v + Y)] of every basis function at every point. If the mass is at rest in contact,
// an impact follows each impulse towards the wall.
MatrixXd means_of_basis_after_impulse(const problem::Problem& problem,
                                      const Coordinates& coordinates, const Basis& basis,
                                      const QuadraturePoints& points) {
  const double r = problem.system.restitution();
  const VectorXd w = points.y.unaryExpr([&](double y) { return coordinates.potential_speed(y); });
  return amplitude::means_after_impulse(problem.impulses.law(), basis, w, points.v,
                                        [r](double at_w, double v) {
                                          if (at_w == 0 && v < 0) return std::pair{-r * v, -r * v};
                                          return std::pair{std::hypot(at_w, v), v};
                                        });
}

// Rates of change rho' and v' between impulses; 0 for the mass at rest in contact.
struct FlowRates {
  VectorXd rho, v;
};
FlowRates flow_rates(const problem::System& system, const Coordinates& coordinates,
                     const QuadraturePoints& points) {
  FlowRates rate{VectorXd::Zero(points.size()), VectorXd::Zero(points.size())};
  for (Index i = 0; i + 1 < points.size(); ++i) {
    const double y = points.y[i], v = points.v[i];
    const double damping =
        (system.damping_polynomial()(y) + system.rayleigh_coefficient() * v * v) * v;
    rate.rho[i] = -v * damping / points.s[i];
    rate.v[i] = -(damping + coordinates.restoring_force(y));
  }
  return rate;
}

}  // namespace

half_plane::ClosureEquations closure_equations(const problem::Problem& problem,
                                               const Coordinates& coordinates, double rho_max,
                                               const half_plane::Confinement& confinement,
                                               Basis basis, QuadraturePoints points,
                                               int wall_points) {
  const FlowRates rate = flow_rates(problem.system, coordinates, points);
  const auto rho_tables = basis.polynomials_in_s().derivative_tables(points.s, 1);
  const auto v_tables = basis.polynomials_in_t().derivative_tables(points.t, 1);
  const auto& members = basis.members();
  const MatrixXd values = products_of_tables(members, rho_tables[0], v_tables[0]);
  const double arrivals = problem.impulses.arrival_rate();

  const half_plane::QuadratureRule wall = half_plane::gauss_legendre_rule(wall_points, 0, rho_max);
  const VectorXd rebound_speed = problem.system.restitution() * wall.nodes;
  const MatrixXd wall_members = basis.basis_values(wall.nodes, -wall.nodes);
  half_plane::GalerkinTables tables{
      .weight = points.weight,
      .members = values,
      .generator_terms =
          products_of_tables(members, rate.rho.asDiagonal() * rho_tables[1], v_tables[0]) +
          products_of_tables(members, rho_tables[0], rate.v.asDiagonal() * v_tables[1]) +
          arrivals * (means_of_basis_after_impulse(problem, coordinates, basis, points) - values),
      .confinement_terms = points.energy.unaryExpr(confinement),
      .wall_weight =
          wall.weight.cwiseProduct(wall.nodes.unaryExpr(&Coordinates::density_prefactor)),
      .wall_members = wall_members,
      .impact_terms = wall.nodes.asDiagonal() *
                      (basis.basis_values(rebound_speed, rebound_speed) - wall_members),
      .wall_confinement_terms = wall.nodes.unaryExpr(
          [&](double rho) { return confinement(amplitude::energy_of_amplitude(rho)); })};
  return {std::move(tables), std::move(basis), std::move(points)};
}

}  // namespace fpkcheck::epc::contact
