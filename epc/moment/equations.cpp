#include "epc/moment/equations.hpp"

#include <algorithm>
#include <boost/math/special_functions/factorials.hpp>
#include <cmath>
#include <functional>
#include <utility>

#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using half_plane::products_of_basis_columns;

namespace {

VectorXd total_force(const problem::System& system, const VectorXd& y, const VectorXd& v) {
  if (!system.has_polynomial_force()) {
    return VectorXd::NullaryExpr(y.size(),
                                 [&](Eigen::Index i) { return system.force(y[i], v[i]); });
  }
  if (system.has_constant_damping())
    return system.damping() * v + y.unaryExpr(system.restoring_force());
  const VectorXd damping = y.unaryExpr(system.damping_polynomial()).array() +
                           system.rayleigh_coefficient() * v.array().square();
  return damping.cwiseProduct(v) + y.unaryExpr(system.restoring_force());
}

// Quadrature points on the walls, with the velocities before and after an impact.
struct WallImpactQuadraturePoints {
  VectorXd y, before, after, weight;

  void add_wall(const problem::Wall& wall, const numerics::QuadratureRule& line) {
    const auto joined = [](const VectorXd& a, const VectorXd& b) {
      VectorXd both(a.size() + b.size());
      both << a, b;
      return both;
    };
    y = joined(y, VectorXd::Constant(line.size(), wall.position));
    before = joined(before, line.quadrature_points_as_vector());
    after = joined(after, line.quadrature_points_as_vector().unaryExpr([&](double v) {
      return -wall.restitution_at_speed(std::abs(v)) * v;
    }));
    weight = joined(weight, line.weights);
  }
};

WallImpactQuadraturePoints incoming_wall_points(const problem::System& system,
                                                const EnergySublevelSet& domain, int points) {
  WallImpactQuadraturePoints all;
  if (system.left_wall())
    all.add_wall(*system.left_wall(), domain.left_wall_quadrature_rule(points));
  if (system.right_wall())
    all.add_wall(*system.right_wall(), domain.right_wall_quadrature_rule(points));
  return all;
}

}  // namespace

half_plane::ClosureEquations closure_equations(
    const problem::Problem& problem, const std::vector<double>& rate_times_moment,
    const EnergySublevelSet& domain, const half_plane::ExponentConfinementTerm& confinement,
    half_plane::OrthonormalBasis basis, half_plane::QuadraturePoints points, int wall_points) {
  const auto& system = problem.system;
  const int n = basis.order();
  const Eigen::Index point_count = points.size();

  // A term of the generator with a time-dependent coefficient has two parts: the generator contains
  // the term at the largest excitation, and time_dependent_terms the difference from it.
  const problem::ExcitationTimeDependence& time = problem.time;
  std::vector<half_plane::TimeDependentGeneratorTerm> time_dependent_terms;
  const auto add_term = [&](std::function<double(double)> factor) {
    time_dependent_terms.push_back({std::move(factor), MatrixXd(point_count, basis.size())});
  };
  const bool has_variable_noise = problem.noise.is_acting() && time.has_intensity_factor();
  if (time.has_rate_factor()) add_term([time](double t) { return time.rate_factor(t) - 1; });
  if (has_variable_noise) add_term([time](double t) { return time.intensity_factor(t) - 1; });
  if (time.has_external_force()) add_term([time](double t) { return time.external_force(t); });

  // L* h_p(y) g_q(v) = v h_p' g_q + h_p [ -(f + g) g_q' + D G g_q'' + sum_j .. g_q^(j) ]. White
  // noise adds the term with the diffusion coefficient D G. The derivatives of the basis functions
  // are computed for blocks of points, since tables for all points would take up to 90 MB.
  constexpr Eigen::Index kPointsPerBlock = 256;
  MatrixXd generator_terms(point_count, basis.size());
  for (Eigen::Index begin = 0; begin < point_count; begin += kPointsPerBlock) {
    const Eigen::Index rows = std::min(kPointsPerBlock, point_count - begin);
    const VectorXd y = points.y.segment(begin, rows), v = points.v.segment(begin, rows);
    const auto y_tables = basis.polynomials_in_s().polynomial_derivative_tables(y, 1);
    const auto v_tables = basis.polynomials_in_t().polynomial_derivative_tables(v, n);
    const auto products = [&](const MatrixXd& of_y, const MatrixXd& of_v) {
      return products_of_basis_columns(basis.basis_functions(), of_y, of_v);
    };
    auto next_term = time_dependent_terms.begin();
    const auto store_term = [&](const MatrixXd& of_v) {
      (next_term++)->values.middleRows(begin, rows) = products(y_tables[0], of_v);
    };
    MatrixXd impulses = MatrixXd::Zero(rows, n + 1);
    for (int j = 1; j <= n; ++j) {
      const double factor =
          rate_times_moment[j] / boost::math::factorial<double>(static_cast<unsigned>(j));
      if (factor != 0) impulses += factor * v_tables[j];
    }
    if (time.has_rate_factor()) store_term(impulses);
    if (problem.noise.is_acting()) {
      const VectorXd diffusion = VectorXd::NullaryExpr(
          rows, [&](Eigen::Index i) { return noise_diffusion_coefficient(problem, y[i], v[i]); });
      const MatrixXd noise = diffusion.asDiagonal() * v_tables[2];
      impulses += noise;
      if (has_variable_noise) store_term(noise);
    }
    if (time.has_external_force()) store_term(v_tables[1]);
    const VectorXd force = total_force(system, y, v);
    generator_terms.middleRows(begin, rows) =
        products(v.asDiagonal() * y_tables[1], v_tables[0]) +
        products(y_tables[0], impulses - force.asDiagonal() * v_tables[1]);
  }

  const WallImpactQuadraturePoints wall = incoming_wall_points(system, domain, wall_points);
  const MatrixXd wall_basis_functions = basis.basis_values(wall.y, wall.before);
  half_plane::GalerkinQuadratureTables tables{
      .weight = points.weight,
      .basis_functions = half_plane::BasisValuesAtPoints(basis, points.s, points.t),
      .generator_terms = std::move(generator_terms),
      .time_dependent_terms = std::move(time_dependent_terms),
      .confinement_terms = points.energy.unaryExpr(confinement),
      .wall_weight = wall.weight,
      .wall_basis_functions = wall_basis_functions,
      .impact_terms = wall.before.cwiseAbs().asDiagonal() *
                      (basis.basis_values(wall.y, wall.after) - wall_basis_functions),
      .wall_confinement_terms = VectorXd::NullaryExpr(wall.y.size(), [&](Eigen::Index i) {
        return confinement(domain.energy(wall.y[i], wall.before[i]));
      })};
  return {std::move(tables), std::move(basis), std::move(points)};
}

}  // namespace fpkcheck::epc::moment
