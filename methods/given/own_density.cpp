#include "methods/given/own_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/look.hpp"
#include "parameters/input_error.hpp"
#include "problem/energy_balance.hpp"
#include "problem/motion_balances.hpp"
#include "transform/balance_residuals.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Moments;
using transform::Solution;
using transform::Status;

// Relative to the peak, or to 1.
constexpr double kNegative = 1e-6, kCutOff = 1e-4, kOffOne = 1e-3;

// The largest average on the edges at which the cells end.
double at_the_end(const transform::GridDensity& grid) {
  double most = 0;
  for (std::size_t i = 0; i < grid.ny(); ++i) {
    most = std::max({most, grid.average(i, 0), grid.average(i, grid.nv() - 1)});
  }
  for (std::size_t j = 0; j < grid.nv(); ++j) most = std::max(most, grid.average(grid.ny() - 1, j));
  return most;
}

// Why the function is no density; empty where it is one.
std::string objection(const transform::GridDensity& grid, double peak, double least, double mass) {
  if (least < -kNegative * peak) {
    return fmt::format("it is negative, down to {:.1e} of its peak", least / peak);
  }
  const double end = at_the_end(grid);
  if (end > kCutOff * peak) {
    return fmt::format(
        "it is {:.1e} of its peak (allowed {:.0e}) where it is cut off, at y = {:.3g} and |y'| = "
        "{:.3g}",
        end / peak, kCutOff, grid.y_edges.back(), grid.v_edges.back());
  }
  if (std::abs(mass - 1) > kOffOne) return fmt::format("its integral is {:.6g} and not 1", mass);
  return {};
}

transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const PointIntegrals& integrals,
                                              const Moments& moments, double mass) {
  const auto& force = problem.system.force();
  const auto mean = [&](const problem::Polynomial& g) {
    return integrals.of([&](double y, double) { return g(y); }) / mass;
  };
  return {.virial = problem::virial_balance(problem, {.mean_displacement = moments.y1,
                                                      .mean_square_velocity = moments.v2,
                                                      .mean_virial = mean(force.times_argument())})
                        .residual(),
          .momentum = problem::momentum_balance(
                          problem, {.mean_force = mean(force),
                                    .impact_momentum = integrals.impact_flux(2) / mass})
                          .residual()};
}

void state_error(const ProblemResiduals& residuals, double accuracy, Solution& solution) {
  const bool was_ok = solution.is_ok();
  state_measured_error(residuals, accuracy, solution);
  if (!was_ok || solution.is_ok() || !solution.error) return;
  // Whether it meets any equation nobody has asked.
  solution.reason = fmt::format(
      "it misses the density of the problem by L1 {:.2g} in p(y) and {:.2g} in p(y') as measured "
      "by its residuals ({:g} is asked for: accuracy)",
      solution.error->y_l1, solution.error->ydot_l1, accuracy);
}

}  // namespace

transform::Identity identity_of(const OwnDensity& own, std::string_view method,
                                const std::string& what) {
  transform::Identity identity{.id = own.label,
                               .method = std::string(method),
                               .order = own.order,
                               .role = transform::Role::given,
                               .family = std::string(method),
                               .trust = static_cast<int>(own.place),
                               .look = given_look(own.place)};
  if (own.equation) {
    identity.role = transform::Role::closure;
    identity.equation = own.equation;
    identity.impact = own.impact;
    identity.meaning = fmt::format("A density of one's own, {}.", what);
  } else {
    identity.meaning = fmt::format(
        "A density of one's own, {}: neither its equation nor its impact is known.", what);
  }
  return identity;
}

double require_density(const OwnDensity& own, const DensityPoints& points,
                       const std::vector<double>& values) {
  const std::size_t nv = points.v().size();
  if (values.size() != points.y().size() * nv) {
    throw InputError(fmt::format("density '{}': {} values (must be {} x {})", own.label,
                                 values.size(), points.y().size(), nv));
  }
  const auto bad = std::ranges::find_if(values, [](double p) { return !std::isfinite(p); });
  if (bad != values.end()) {
    const auto k = static_cast<std::size_t>(bad - values.begin());
    throw InputError(fmt::format("density '{}': p({:.4g}, {:.4g}) is {} (must be a finite number)",
                                 own.label, points.y()[k / nv], points.v()[k % nv], *bad));
  }
  const double mass = PointIntegrals(points, values).mass();
  if (!(mass > 0) || !std::isfinite(mass)) {
    throw InputError(
        fmt::format("density '{}': its integral is {:.4g} (must be positive)", own.label, mass));
  }
  return mass;
}

Solution solution_of(const problem::Problem& problem, const Setting& setting, const OwnDensity& own,
                     const OwnFunction& how, const DensityPoints& points,
                     std::vector<double> values, double mass) {
  if (how.normalise) {
    for (double& value : values) value /= mass;
  }
  const PointIntegrals integrals(points, values);
  const auto [least, peak] = std::ranges::minmax(values);
  Solution solution;
  auto grid = integrals.averages();
  solution.mass = integrals.mass();
  solution.min_density = least / peak;
  solution.moments = integrals.moments(solution.mass);
  const auto& moments = solution.moments;
  solution.energy_residual =
      problem::energy_residual(problem, own.impact,
                               {.mean_velocity = moments.v1,
                                .mean_square_velocity = moments.v2,
                                .impact_energy_flux = integrals.impact_flux(3) / solution.mass});
  solution.reason =
      how.objection.empty() ? objection(grid, peak, least, solution.mass) : how.objection;
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
  solution.density = std::move(grid);

  transform::Observer observer;
  if (how.normalise) observer.result("normalised_by", mass);
  observe(observer, balance_residuals(problem, integrals, moments, solution.mass));
  solution.observations = observer.take();
  if (own.equation && setting.residuals != nullptr) {
    state_error(*setting.residuals, how.accuracy, solution);
  }
  return solution;
}

Method own_function(const OwnDensity& own, const OwnFunction& how, const DensityPoints& points,
                    std::vector<double> values) {
  const double mass = require_density(own, points, values);
  return {.identity = identity_of(own, transform::kGivenAsFunction, "given as a function"),
          .solve = [own, how, points, mass, values = std::move(values)](
                       const problem::Problem& problem, const Setting& setting) {
            return solution_of(problem, setting, own, how, points, values, mass);
          }};
}

}  // namespace fpkcheck::methods
