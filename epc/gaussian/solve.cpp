#include <fmt/format.h>

#include <cmath>
#include <string>

#include "epc/formulations.hpp"
#include "epc/gaussian/density_support.hpp"
#include "epc/gaussian/gaussian_weighted_basis.hpp"
#include "epc/gaussian/root_search.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using transform::Status;

// Returns the smallest closure order n-2 whose density is compared with the density of closure
// order n. For oscillators without a wall, closure order 2 is excluded for densities with several
// peaks or a ring, which no Gaussian density approximates.
int first_comparable_order(const problem::Problem& problem) {
  return problem.system.left_wall() ? 2 : 4;
}

std::string inadmissible_reason(const DensitySupport& support,
                                const ExponentBehaviourAtInfinity& form,
                                const transform::Solution& solution,
                                const std::optional<double>& distance_to_density_before) {
  if (!(support.support_edge_to_peak_density_ratio() < kMaxSupportEdgeDensity)) {
    return fmt::format(
        "the density is {:.1e} of its peak on the edge of its support (limit {:.0e}); the support "
        "cuts off about {:.1e} of the probability, {}",
        support.support_edge_to_peak_density_ratio(), kMaxSupportEdgeDensity,
        support.probability_outside_support(),
        describe_exponent_at_infinity(form, "(x1/sigma1, x2/sigma2)"));
  }
  if (!(std::abs(solution.mass - 1) <= kClosureMassTolerance)) {
    return fmt::format("the mass of the density in the box around its support is {:.6f}, not 1",
                       solution.mass);
  }
  if (!(std::abs(solution.energy_residual) <= kMaxClosureEnergyResidual)) {
    return fmt::format(
        "the balance of power has a residual of {:.0f} % of the input (limit {:.0f} %): the root "
        "approximates no stationary density",
        100 * std::abs(solution.energy_residual), 100 * kMaxClosureEnergyResidual);
  }
  if (distance_to_density_before.value_or(0) > kMaxL1DistanceToPreviousOrder) {
    return fmt::format(
        "the L1 distance of p(y) and p(y') to order n-2 is {:.2f} (limit {}): the root does not "
        "continue order n-2",
        *distance_to_density_before, kMaxL1DistanceToPreviousOrder);
  }
  return "";
}

// Returns the reason why a root of a problem without a wall is inadmissible: a large residual of
// the virial balance. A Gaussian density in the middle of a double well satisfies the projected
// equations, but not the virial balance.
std::string virial_inadmissible_reason(const problem::Problem& problem,
                                       const transform::BalanceResiduals& balances) {
  const double virial = std::abs(balances.virial.value_or(0));
  if (problem.system.left_wall() || virial <= kMaxClosureEnergyResidual) return "";
  return fmt::format(
      "the virial balance has a residual of {:.0f} % (limit {:.0f} %): the root approximates no "
      "stationary density",
      100 * virial, 100 * kMaxClosureEnergyResidual);
}

void assess_closure_root(const problem::Problem& problem, const ExponentPolynomial& q,
                         const StandardDeviations& sigma,
                         const std::optional<ExponentPolynomial>& previous, ClosureResult& result) {
  const bool has_wall = problem.system.left_wall().has_value();
  const DensitySupport support(q, sigma);
  const ExponentBehaviourAtInfinity form = leading_form(q, sigma);
  auto& [solution, summary] = result;
  summary.coefficients = q.terms();
  summary.leading_form = form;
  summary.support = {.least_radius = support.smallest_support_radius(),
                     .greatest_radius = support.largest_support_radius(),
                     .y_max = support.x1_max(),
                     .v_max = support.x2_max(),
                     .edge_density = support.support_edge_to_peak_density_ratio(),
                     .cut_off = support.probability_outside_support()};
  summary.frame = {
      .variables = has_wall ? ExponentCoordinates::plane : ExponentCoordinates::physical,
      .coordinates = problem.frame,
      .log_constant = log_normalising_constant(support),
      .deviations = sigma};

  const transform::SmoothDensity density = density_on_support(q, support, has_wall);
  summary.support->y_min = density.y_min;
  const transform::QuadratureMarginals marginals =
      store_density(problem, ImpactCondition::delta, density, result);
  std::optional<double> distance_to_density_before;
  if (previous) {
    const DensitySupport before(*previous, sigma);
    auto before_density = density_on_support(*previous, before, has_wall);
    // Equal values of y_min give the densities of closure orders n and n-2 equal quadrature panels
    before_density.y_min = density.y_min;
    summary.distance_to_previous = summed_l1_distance(
        marginals,
        transform::marginals_at_quadrature_points(before_density, density.y_max, density.v_max));
    if (before.support_edge_to_peak_density_ratio() < kMaxSupportEdgeDensity &&
        previous->degree() >= first_comparable_order(problem)) {
      distance_to_density_before = summary.distance_to_previous;
    }
  }
  solution.reason = inadmissible_reason(support, form, solution, distance_to_density_before);
  if (solution.reason.empty())
    solution.reason = virial_inadmissible_reason(problem, summary.balances);
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
}

}  // namespace

ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options) {
  const ClosureRootSearchResult search = find_closure_root(problem, options);
  ClosureResult result;
  result.summary.iterations = search.iterations;
  result.summary.residual = search.residual;
  result.summary.branch = search.branch;
  result.summary.plain_newton_converges = search.plain_newton_converges;
  result.summary.disc_sensitivity = search.disc_sensitivity;
  if (search.root) {
    result.summary.condition = search.condition;
    assess_closure_root(problem, *search.root, search.sigma, search.previous, result);
  } else {
    result.solution.status = Status::not_converged;
    result.solution.reason = search.failure;
  }
  return result;
}

}  // namespace fpkcheck::epc::gaussian
