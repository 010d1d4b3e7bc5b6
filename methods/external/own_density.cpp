#include "methods/external/own_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/input_error.hpp"
#include "methods/look.hpp"
#include "problem/energy_balance.hpp"
#include "problem/features.hpp"
#include "problem/motion_balances.hpp"
#include "transform/balance_residuals.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Moments;
using transform::Solution;
using transform::Status;

// Tolerances: the first two relative to the peak, the third to a mass of 1.
constexpr double kNegative = 1e-6, kCutOff = 1e-4, kOffOne = 1e-3;

// The largest average in the outermost cells, except at walls.
double at_the_end(const transform::GridDensity& grid, const DensityPoints& points) {
  double most = 0;
  for (std::size_t i = 0; i < grid.ny(); ++i) {
    most = std::max({most, grid.average(i, 0), grid.average(i, grid.nv() - 1)});
  }
  for (std::size_t j = 0; j < grid.nv(); ++j) {
    if (!points.begin_at_wall()) most = std::max(most, grid.average(0, j));
    if (!points.end_at_wall()) most = std::max(most, grid.average(grid.ny() - 1, j));
  }
  return most;
}

// "at y = 2 and |y'| = 3"
std::string ends_of(const transform::GridDensity& grid, const DensityPoints& points) {
  std::string ends;
  if (!points.begin_at_wall()) ends += fmt::format("y = {:.3g}, ", grid.y_edges.front());
  if (!points.end_at_wall()) ends += fmt::format("y = {:.3g}, ", grid.y_edges.back());
  if (!ends.empty()) ends.replace(ends.size() - 2, 2, " and ");
  return fmt::format("at {}|y'| = {:.3g}", ends, grid.v_edges.back());
}

// The reason for the status inadmissible; empty where the function is a density.
std::string objection(const transform::GridDensity& grid, const DensityPoints& points, double peak,
                      double least, double mass) {
  if (least < -kNegative * peak) {
    return fmt::format("the density is negative, down to {:.1e} of its peak", least / peak);
  }
  const double end = at_the_end(grid, points);
  if (end > kCutOff * peak) {
    return fmt::format("the density is cut off at {:.1e} of its peak (limit {:.0e}), {}",
                       end / peak, kCutOff, ends_of(grid, points));
  }
  if (std::abs(mass - 1) > kOffOne) return fmt::format("the integral is {:.6g}, not 1", mass);
  return {};
}

// The residuals of the balances in wall coordinates.
transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const PointIntegrals& integrals, double mass) {
  const problem::Frame frame = problem::wall_frame(problem.system);
  const problem::Problem seen = problem::to_wall_coordinates(frame, problem);
  const auto& force = seen.system.force();
  const auto mean = [&](const auto& of) {
    return integrals.of([&](double y, double v) { return of(frame.x(y), frame.v(v)); }) / mass;
  };
  const auto into = [&](bool right) {
    return (right ? integrals.right_flux(2) : integrals.left_flux(2)) / mass;
  };
  const problem::VirialTerms virial{
      .mean_displacement = mean([](double x, double) { return x; }),
      .mean_square_velocity = mean([](double, double v) { return v * v; }),
      .mean_virial = mean([&](double x, double) { return x * force(x); }),
      .right_momentum = frame.mirrored ? 0 : into(true),
      .mean_y_cubed_velocity = mean([](double x, double v) { return x * v * v * v; })};
  problem::MomentumTerms momentum{
      .mean_force = mean([&](double x, double) { return force(x); }),
      .impact_momentum = into(frame.mirrored),
      .right_momentum = virial.right_momentum,
      .mean_cubed_velocity = mean([](double, double v) { return v * v * v; })};
  if (!problem::is_paper_oscillator(problem)) {
    momentum.mean_absolute_force = mean([&](double x, double) { return std::abs(force(x)); });
  }
  transform::BalanceResiduals residuals{.virial = problem::virial_balance(seen, virial).residual()};
  // Without a wall and with zero-mean impulses both sides of the momentum balance are 0.
  const bool pushed = problem.impulses.rate_moment(1) != 0;
  if (problem.system.left() || problem.system.right() || pushed) {
    residuals.momentum = problem::momentum_balance(seen, momentum).residual();
  }
  return residuals;
}

}  // namespace

transform::Identity identity_of(const OwnDensity& own, std::string_view method,
                                const std::string& what) {
  transform::Identity identity{.id = own.label,
                               .method = std::string(method),
                               .order = own.order,
                               .role = transform::Role::external,
                               .family = std::string(method),
                               .trust = static_cast<int>(own.place),
                               .plot_style = given_look(own.place)};
  if (own.equation) {
    identity.role = transform::Role::closure;
    identity.equation = own.equation;
    identity.impact = own.impact;
    identity.meaning = fmt::format("An external density, {}.", what);
  } else {
    identity.meaning =
        fmt::format("An external density, {}; its equation and impact are unknown.", what);
  }
  return identity;
}

void note_rest(const problem::Problem& problem, transform::MetricBuilder& builder) {
  if (!problem::features(problem).rests_in_contact) return;
  builder.text(
      "notes[0]",
      "the mass at rest in contact with a wall is not part of the density and counts as missing");
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
        fmt::format("density '{}': the integral is {:.4g} (must be positive)", own.label, mass));
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
  const problem::System& system = problem.system;
  const double damping_power = integrals.of([&](double y, double v) {
    return v * v * (system.damping_polynomial()(y) + system.rayleigh() * v * v);
  });
  solution.energy_residual =
      problem::energy_residual(problem, own.impact,
                               {.mean_velocity = moments.v1,
                                .mean_square_velocity = moments.v2,
                                .impact_energy_flux = integrals.left_flux(3) / solution.mass,
                                .right_energy_flux = integrals.right_flux(3) / solution.mass,
                                .mean_damping_power = damping_power / solution.mass});
  solution.reason =
      how.objection.empty() ? objection(grid, points, peak, least, solution.mass) : how.objection;
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
  solution.density = std::move(grid);

  transform::MetricBuilder builder;
  if (how.normalise) builder.result("normalised_by", mass);
  add_metrics(builder, balance_residuals(problem, integrals, solution.mass));
  note_rest(problem, builder);
  solution.metrics = builder.take();
  if (own.equation && setting.residuals != nullptr) {
    // An empty prefix of the reason: the density was not tested against the equation.
    state_measured_error(*setting.residuals, how.accuracy, solution, {}, "");
  }
  return solution;
}

Method own_function(const OwnDensity& own, const OwnFunction& how, const DensityPoints& points,
                    std::vector<double> values) {
  const double mass = require_density(own, points, values);
  return {.identity = identity_of(own, transform::kExternalFunction, "given as a function"),
          .solve = [own, how, points, mass, values = std::move(values)](
                       const problem::Problem& problem, const Setting& setting) {
            return solution_of(problem, setting, own, how, points, values, mass);
          }};
}

}  // namespace fpkcheck::methods
