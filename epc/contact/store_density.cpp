#include "epc/contact/store_density.hpp"

#include <cmath>

#include "epc/amplitude/amplitude_phase.hpp"
#include "epc/amplitude/impulse_means.hpp"
#include "problem/balances.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using half_plane::QuadraturePoints;

// Returns cell edges from 0 to `end`. The width of the first cell next to 0 is `first` times `end`.
// The widths of the cells grow in proportion to their distance from 0, up to a largest width.
std::vector<double> edges_graded_to_zero(double end, double first, double growth) {
  constexpr int kEven = 120;
  std::vector<double> edges{0};
  for (double at = first * end; at < end; at += std::min((growth - 1) * at, end / kEven)) {
    edges.push_back(at);
  }
  if (end - edges.back() < end / (2 * kEven)) edges.pop_back();
  edges.push_back(end);
  return edges;
}

std::vector<double> join_with_mirror_image(const std::vector<double>& edges) {
  std::vector<double> all;
  for (auto at = edges.rbegin(); at + 1 != edges.rend(); ++at) all.push_back(-*at);
  all.insert(all.end(), edges.begin(), edges.end());
  return all;
}

// Discrete approximation of the stationary probability law: points with probabilities, the last
// point being the atom at rest.
struct DiscreteAmplitudeLaw {
  QuadraturePoints points;
  VectorXd mass;

  double probability_of_rest() const { return mass[mass.size() - 1]; }
  template <class Function>
  double mean_of(const Function& g) const {
    double sum = 0;
    for (Index i = 0; i < mass.size(); ++i) sum += mass[i] * g(points.y[i], points.v[i]);
    return sum;
  }
};

DiscreteAmplitudeLaw make_discrete_law(const AmplitudeVelocityCoordinates& coordinates,
                                       const half_plane::ClosureRootSearchResult& root,
                                       const transform::SmoothDensity& density) {
  const half_plane::ClosureDensity& closure = root.closure;
  DiscreteAmplitudeLaw law{
      .points = amplitude::quadrature_points(
          coordinates, amplitude::amplitude_of_energy(closure.support), {}, root.quadrature),
      .mass = {}};
  law.mass = law.points.weight;
  const Index last = law.mass.size() - 1;
  for (Index i = 0; i < last; ++i) {
    const double factor = AmplitudeVelocityCoordinates::density_prefactor(law.points.s[i]);
    law.mass[i] *= density.value(law.points.y[i], law.points.v[i]) / factor;
  }
  law.mass[last] *= std::exp(closure.q(0, 0) - closure.log_normalisation);
  return law;
}

transform::Moments moments_of_law(const problem::WallFrame& frame,
                                  const DiscreteAmplitudeLaw& law) {
  const auto mean = [&](int y_power, int v_power) {
    return law.mean_of([&](double y, double v) {
      return std::pow(frame.physical_y(y), y_power) * std::pow(frame.physical_velocity(v), v_power);
    });
  };
  return {.y1 = mean(1, 0),
          .y2 = mean(2, 0),
          .y4 = mean(4, 0),
          .v1 = mean(0, 1),
          .v2 = mean(0, 2),
          .v4 = mean(0, 4)};
}

// Returns the contribution of the impulses Y < 0 (towards the wall) to the moment E[|Y|^power].
double partial_moment_towards_wall(const problem::ImpulseLaw& law, int power) {
  const auto after = amplitude::GradedImpulseQuadrature(law)(0, 0);
  double sum = 0;
  for (std::size_t k = 0; k < after.v.size(); ++k) {
    if (after.v[k] < 0) sum += after.probability[k] * std::pow(-after.v[k], power);
  }
  return sum;
}

// Returns the moment int u^power p(0, -u) du of impact speeds u of the density p at the wall y = 0.
// The density p(y, v) at the wall excludes rest in contact with the wall.
double moment_of_wall_flux(const transform::SmoothDensity& density, int points, int power) {
  const auto wall = numerics::gauss_legendre_rule(points, 0, density.v_max);
  double sum = 0;
  for (Index i = 0; i < wall.size(); ++i) {
    sum += wall.weights[i] * std::pow(wall.points[i], power) * density.value(0, -wall.points[i]);
  }
  return sum;
}

transform::BalanceResiduals balance_residuals_of_law(const problem::Problem& problem,
                                                     const DiscreteAmplitudeLaw& law,
                                                     double momentum_of_impacts,
                                                     double release_rate) {
  const problem::System& system = problem.system;
  const auto& force = system.restoring_force();
  problem::VirialBalanceTerms virial{
      .mean_displacement = law.mean_of([](double y, double) { return y; }),
      .mean_square_velocity = law.mean_of([](double, double v) { return v * v; }),
      .mean_virial = law.mean_of([&](double y, double) { return y * force(y); })};
  problem::MomentumBalanceTerms momentum{
      .mean_force = law.mean_of([&](double y, double) { return force(y); }),
      .left_impact_momentum =
          problem::impact_momentum_rate(system.left_wall(), momentum_of_impacts),
      .contact_momentum_rate =
          force(0.0) * law.probability_of_rest() +
          (1 + system.restitution()) * release_rate *
              partial_moment_towards_wall(problem.impulses.amplitude_law(), 1)};
  if (system.rayleigh_coefficient() != 0) {
    virial.mean_y_cubed_velocity = law.mean_of([](double y, double v) { return y * v * v * v; });
    momentum.mean_cubed_velocity = law.mean_of([](double, double v) { return v * v * v; });
  }
  return {.virial = problem::virial_balance(problem, virial).relative_balance_residual(),
          .momentum = problem::momentum_balance(problem, momentum).relative_balance_residual()};
}

}  // namespace

transform::GridDensity average_on_graded_cells(const transform::SmoothDensity& density) {
  // Near the corner y = v = 0 of the half-plane, displacements y are of the order of v^2. The first
  // cell in y therefore has the width kFirst^2, and the first cell in v the width kFirst, relative
  // to the ranges of y and v. The first cells contain a probability of the order of kFirst.
  constexpr double kFirst = 1e-6, kGrowth = 1.3;
  return transform::average_over_cells(
      density, edges_graded_to_zero(density.y_max, kFirst * kFirst, kGrowth * kGrowth),
      join_with_mirror_image(edges_graded_to_zero(density.v_max, kFirst, kGrowth)));
}

void store_density_and_atom(const problem::Problem& problem,
                            const AmplitudeVelocityCoordinates& coordinates,
                            const half_plane::ClosureRootSearchResult& root,
                            const transform::SmoothDensity& density, ClosureResult& result) {
  auto& [solution, summary] = result;
  const problem::System& system = problem.system;
  const DiscreteAmplitudeLaw law = make_discrete_law(coordinates, root, density);
  const double release_rate = problem.impulses.arrival_rate() * law.probability_of_rest();
  transform::GridDensity cells = average_on_graded_cells(density);
  solution.mass = transform::mass(cells) + law.probability_of_rest();
  solution.density = std::move(cells);
  solution.atoms = {{.y = 0,
                     .probability = law.probability_of_rest(),
                     .standard_error = {},
                     .error_estimate = {}}};
  solution.moments = moments_of_law(problem.frame, law);
  summary.moments = moments_of_law({}, law);
  problem::PowerBalanceTerms energy{
      .mean_velocity = summary.moments.v1,
      .mean_square_velocity = summary.moments.v2,
      .left_impact_loss = problem::impact_energy_loss_rate(
          system.left_wall(), problem::ImpactCondition::map,
          moment_of_wall_flux(density, root.quadrature.wall, 3) +
              release_rate * partial_moment_towards_wall(problem.impulses.amplitude_law(), 2))};
  if (!system.has_constant_damping()) {
    energy.mean_damping_power = law.mean_of([&](double y, double v) {
      return (system.damping_polynomial()(y) + system.rayleigh_coefficient() * v * v) * v * v;
    });
  }
  solution.energy_residual = problem::power_balance_residual(problem, energy);
  summary.balances = balance_residuals_of_law(
      problem, law, moment_of_wall_flux(density, root.quadrature.wall, 2), release_rate);
}

}  // namespace fpkcheck::epc::contact
