#include "approximations/averaging/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "approximations/averaging/band_probabilities.hpp"
#include "approximations/averaging/energy_density.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/energy_averaging.hpp"
#include "problem/problem_features.hpp"
#include "transform/smooth_density_results.hpp"

namespace fpkcheck::averaging {
namespace {

using transform::Status;

std::vector<double> band_probabilities(const problem::Problem& problem, const EnergyLevels& levels,
                                       problem::DensityEquation equation) {
  if (equation == problem::DensityEquation::kf && problem.impulses.is_acting()) {
    return stationary_band_probabilities(problem, levels);
  }
  std::vector<double> probabilities;
  for (const auto& band : levels.energy_bands()) probabilities.push_back(band.mass);
  return probabilities;
}

}  // namespace

transform::Solution solve_averaged_equation(const problem::Problem& problem,
                                            const AveragingOptions& options) {
  validate(options);
  const base::Stopwatch stopwatch;
  transform::Solution solution{.identity = solution_identity(options)};
  // With this number of bands the relative residual of the power balance of case 1 is 1.1e-3; with
  // 1400 bands it is 1.4e-4, but the time is 8 times as long.
  constexpr int kBandCount = 600;
  const EnergyLevels levels(std::make_shared<const problem::EnergyAveraging>(problem, kBandCount));
  const auto probabilities = band_probabilities(problem, levels, options.equation);
  const double smallest = *std::ranges::min_element(probabilities);
  // Rounding errors of the linear solution are below kRounding.
  constexpr double kRounding = 1e-10;
  if (!std::isfinite(smallest) || smallest < -kRounding) {
    solution.status = Status::inadmissible;
    solution.reason =
        fmt::format("the averaged equation gives an energy band the probability {:.1e}", smallest);
  } else {
    transform::SmoothDensity density = joint_density(levels, probabilities);
    const double mass =
        transform::marginals_at_quadrature_points(density, density.y_max, density.v_max).mass;
    density.value = [value = density.value, mass](double y, double v) {
      return value(y, v) / mass;
    };
    const auto results =
        transform::store_smooth_density(problem, problem::ImpactCondition::map, density, solution);
    solution.status = Status::ok;
    transform::SolverMetricsBuilder metrics;
    metrics.add_diagnostic_metric("energy_bands",
                                  transform::value_from_count(probabilities.size()));
    transform::add_balance_metrics(metrics, results.balances);
    solution.metrics = metrics.take_metrics();
  }
  solution.seconds = stopwatch.seconds();
  return solution;
}

std::string unsupported_reason(const problem::Problem& problem, const AveragingOptions&) {
  if (problem::problem_features(problem).rests_in_contact) {
    return "the mass comes to rest at a wall: a density of the energy has no atom; use fd or mcs";
  }
  return "";
}

}  // namespace fpkcheck::averaging
