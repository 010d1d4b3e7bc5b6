#include "approximations/path_integration/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "approximations/path_integration/short_time_operator.hpp"
#include "base/process/stopwatch.hpp"
#include "numerics/splines/spline_basis.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"
#include "transform/richardson.hpp"
#include "transform/smooth_density_results.hpp"

namespace fpkcheck::path_integration {
namespace {

using Eigen::MatrixXd;
using transform::Status;

// The time between two vectors of the Krylov space is half a period.
constexpr double kPhaseOfRepetition = 3;

// Ratio of the widths of intervals far from a wall and at a wall with losses. At the wall the
// density jumps by the factor 1/r^2 at v = 0. The error of interpolation in the probability is of
// the size of this jump times the area of a cell.
constexpr double kWallGrading = 32;

bool has_impact_losses(const problem::System& system) {
  const auto has_losses = [](const std::optional<problem::Wall>& wall) {
    return wall && (!wall->has_constant_restitution() || wall->restitution < 1);
  };
  return has_losses(system.left_wall()) || has_losses(system.right_wall());
}

std::vector<double> uniform_breaks(double begin, double end, int intervals) {
  std::vector<double> breaks;
  for (int k = 0; k <= intervals; ++k)
    breaks.push_back(std::lerp(begin, end, static_cast<double>(k) / intervals));
  return breaks;
}

// Returns break points from 0 to `end` whose distances increase from about width / kWallGrading to
// `width` within a few intervals.
std::vector<double> graded_breaks(double end, double width) {
  const double uniform_from = 3 * width, finest = uniform_from / kWallGrading;
  const double count = (end + (uniform_from - finest) * std::log((end + finest) / finest)) / width;
  return numerics::graded_break_points(end, static_cast<int>(std::ceil(count)), finest,
                                       uniform_from);
}

std::vector<double> displacement_breaks(const problem::Walls& walls, double begin, double end,
                                        double width) {
  if (!walls.left && !walls.right)
    return uniform_breaks(begin, end, static_cast<int>(std::ceil((end - begin) / width)));
  const bool is_graded_twice = walls.left && walls.right;
  const auto distances = graded_breaks(is_graded_twice ? (end - begin) / 2 : end - begin, width);
  std::vector<double> breaks;
  if (walls.left) {
    for (const double distance : distances) breaks.push_back(begin + distance);
    if (is_graded_twice) breaks.pop_back();
  }
  if (walls.right) {
    for (auto d = distances.rbegin(); d != distances.rend(); ++d) breaks.push_back(end - *d);
  }
  return breaks;
}

// Returns symmetric break points without a break at v = 0. The number of splines is even, so that
// no point of the splines is the state of rest at a wall.
std::vector<double> velocity_breaks(double end, int intervals, bool is_graded) {
  if (!is_graded) return uniform_breaks(-end, end, intervals + 1 - intervals % 2);
  const auto speeds = graded_breaks(end, 2 * end / intervals);
  std::vector<double> breaks;
  for (auto speed = speeds.rbegin(); speed + 1 != speeds.rend(); ++speed) breaks.push_back(-*speed);
  breaks.insert(breaks.end(), speeds.begin() + 1, speeds.end());
  return breaks;
}

struct PhasePlaneRange {
  double y_begin, y_end, v_end;
};

// The displacement between the walls, and without a wall up to `factor` times the distance of the
// motion scales from the mean.
PhasePlaneRange phase_plane_range(const problem::Walls& walls, const problem::MotionScales& scales,
                                  double factor) {
  const auto end = [&](const std::optional<problem::Wall>& wall, double limit) {
    return wall ? wall->position : std::lerp(scales.centre, limit, factor);
  };
  return {end(walls.left, scales.y_low), end(walls.right, scales.y_high), factor * scales.v_high};
}

bool has_kinks(const problem::Problem& problem, const PhasePlaneRange& range) {
  return !problem::coefficient_kinks_in_y(problem, range.y_begin, range.y_end).empty() ||
         !problem::coefficient_kinks_in_v(problem, -range.v_end, range.v_end).empty();
}

struct SplineDensity {
  PhasePlaneSplines splines;
  PhasePlaneRange range;
  MatrixXd coefficients = {};
  double growth_rate = 0;
  double time_step = 0;
  bool has_converged = false;

  double operator()(double y, double v) const { return splines.value(coefficients, y, v); }
};

// Returns the product of the number of intervals and the larger of the two time steps, which is
// equal for all grids.
double intervals_times_step(const problem::System& system, const problem::MotionScales& scales,
                            const PhasePlaneRange& range, double fewest_intervals) {
  // With these products, the errors of the splitting and of the splines of case 1 and of case
  // `duffing` are of the same size.
  const double product = (has_impact_losses(system) ? 12 : 24) / scales.frequency;
  constexpr int kSamples = 64;
  double damping = 0;
  for (const double y : uniform_breaks(range.y_begin, range.y_end, kSamples))
    damping = std::max(damping, system.force_slope_in_v(y, 0));
  // The motion contracts the density in v by exp(-damping step), and splines do not resolve a
  // density that is narrower than an interval. Much smaller steps would take too long.
  constexpr double kLargestContraction = 1, kLargestReduction = 4;
  return std::min(product, std::max(kLargestContraction / damping * fewest_intervals,
                                    product / kLargestReduction));
}

using Start = std::function<double(double, double)>;

// Computes the stationary densities with two time steps, T and T/2, and extrapolates to T = 0.
SplineDensity solve_on_grid(const problem::Problem& problem, problem::DensityEquation equation,
                            const problem::MotionScales& scales, const PhasePlaneRange& range,
                            int intervals, double time_step, const Start& start) {
  const bool has_losses = has_impact_losses(problem.system);
  const double v_width = 2 * range.v_end / intervals;
  const double y_length = range.y_end - range.y_begin;
  // Equal numbers of intervals per standard deviation, but half of `intervals` at the least
  const double y_width =
      std::min(v_width * scales.displacement_deviation / scales.velocity_deviation,
               y_length / (0.5 * intervals));
  SplineDensity density{
      .splines = {SplineInterpolation(
                      displacement_breaks(has_losses ? problem.system.walls() : problem::Walls{},
                                          range.y_begin, range.y_end, y_width)),
                  SplineInterpolation(velocity_breaks(range.v_end, intervals, has_losses))},
      .range = range};
  const auto& [y, v] = density.splines;
  MatrixXd values(v.size(), y.size());
  for (int j = 0; j < y.size(); ++j) {
    for (int i = 0; i < v.size(); ++i)
      values(i, j) =
          start(y.points()[static_cast<std::size_t>(j)], v.points()[static_cast<std::size_t>(i)]);
  }
  density.time_step = time_step;
  // Phase of a Runge-Kutta step, smaller where steps cross kinks of the force
  const double motion_phase = has_kinks(problem, range) ? 0.01 : 0.05;
  const auto solve = [&](double step) {
    const ShortTimeOperator one_step(problem, equation, density.splines, step,
                                     motion_phase / scales.frequency);
    return stationary_spline(one_step, density.splines, values,
                             kPhaseOfRepetition / scales.frequency);
  };
  const StationarySpline coarse = solve(density.time_step);
  if (!coarse.has_converged) return density;
  values = coarse.values;
  const StationarySpline fine = solve(density.time_step / 2);
  density.has_converged = fine.has_converged;
  if (!fine.has_converged) return density;
  density.coefficients = (4 * fine.coefficients - coarse.coefficients) / 3;
  density.growth_rate = fine.growth_rate;
  return density;
}

// Smallest and largest value at the points of the splines, and largest absolute value near the ends
// of the range that are no walls. At the ends themselves the density may vanish, since the earlier
// states of points there are outside of the range.
struct DensityExtremes {
  double least = 0, peak = 0, near_ends = 0;
};

DensityExtremes density_extremes(const problem::Walls& walls, const SplineDensity& density) {
  DensityExtremes result;
  const auto& [y, v] = density.splines;
  const auto& [y_begin, y_end, v_end] = density.range;
  constexpr double kMargin = 0.05;  // part of the range
  const auto near_end = [&](double at_y, double at_v) {
    result.near_ends = std::max(result.near_ends, std::abs(density(at_y, at_v)));
  };
  for (const double at_v : v.points()) {
    for (const double at_y : y.points()) {
      const double value = density(at_y, at_v);
      result.least = std::min(result.least, value);
      result.peak = std::max(result.peak, value);
    }
    if (!walls.left) near_end(y_begin + kMargin * (y_end - y_begin), at_v);
    if (!walls.right) near_end(y_end - kMargin * (y_end - y_begin), at_v);
  }
  for (const double at_y : y.points()) {
    for (const double sign : {-1.0, 1.0}) near_end(at_y, sign * (1 - 2 * kMargin) * v_end);
  }
  return result;
}

// The solution on one grid, without a status.
transform::Solution solution_on_grid(const problem::Problem& problem,
                                     const PathIntegrationOptions& options,
                                     const std::shared_ptr<const SplineDensity>& density) {
  transform::Solution solution{.identity = solution_identity(options)};
  const auto results = transform::store_smooth_density(
      problem, problem::ImpactCondition::map,
      {.value = [density](double y, double v) { return (*density)(y, v); },
       .y_max = density->range.y_end,
       .v_max = density->range.v_end,
       .y_min = density->range.y_begin},
      solution);
  const auto extremes = density_extremes(problem.system.walls(), *density);
  solution.min_density = extremes.least / extremes.peak;
  transform::SolverMetricsBuilder metrics;
  metrics
      .add_diagnostic_metric("grid.displacement_splines",
                             transform::value_from_count(density->splines.y.size()))
      .add_diagnostic_metric("grid.velocity_splines",
                             transform::value_from_count(density->splines.v.size()))
      .add_diagnostic_metric("grid.time_step", density->time_step / 2)
      .add_diagnostic_metric("grid.probability_growth_rate", density->growth_rate);
  transform::add_balance_metrics(metrics, results.balances);
  solution.metrics = metrics.take_metrics();
  return solution;
}

constexpr double kRatio = transform::kRefinementRatio;

// Returns the error of the finest of three grids.
transform::ErrorEstimate error_estimate(const std::vector<transform::GridLevelSolution>& levels,
                                        int scheme_order, double probability_defect) {
  const std::size_t last = levels.size() - 1;
  const auto before = transform::grid_level_difference(levels[last - 2], levels[last - 1]);
  const auto change = transform::grid_level_difference(levels[last - 1], levels[last]);
  const auto estimate = transform::richardson_estimate(before, change, kRatio, scheme_order);
  auto error = estimate.error;
  const auto l1_error = [&](double coarser, double finer) {
    return std::max(probability_defect,
                    transform::kErrorSafetyFactor *
                        transform::richardson_error_from_differences(
                            coarser, finer, estimate.reduction_ratio, estimate.factor));
  };
  error.y_l1 = l1_error(before.y_l1, change.y_l1);
  error.ydot_l1 = l1_error(before.ydot_l1, change.ydot_l1);
  for (const auto& named : transform::kMoments)
    error.moments.*named.moment *= transform::kErrorSafetyFactor;
  return error;
}

}  // namespace

transform::Solution solve_by_path_integration(const problem::Problem& problem,
                                              const PathIntegrationOptions& options) {
  validate(options);
  const base::Stopwatch stopwatch;
  const auto scales = problem::motion_scales(problem);
  const auto& walls = problem.system.walls();
  constexpr int kFewestIntervals = 32, kMostIntervals = 128;
  constexpr double kTargetError = 1e-4;
  const int finest = options.intervals.value_or(kMostIntervals);
  const double fewest = options.intervals ? finest / 2.0 : kFewestIntervals;
  double intervals = fewest;

  Start start = [&scales](double y, double v) {
    const double in_y = (y - scales.centre) / scales.displacement_deviation;
    const double in_v = v / scales.velocity_deviation;
    return std::exp(-(in_y * in_y + in_v * in_v) / 2);
  };
  double range_factor = 1;
  std::vector<transform::GridLevelSolution> levels;
  std::vector<double> y_edges, v_edges;
  transform::Solution solution{.identity = solution_identity(options)};
  for (;;) {
    const auto range = phase_plane_range(walls, scales, range_factor);
    const double time_step =
        intervals_times_step(problem.system, scales, range, fewest * range_factor) / intervals;
    const auto density = std::make_shared<const SplineDensity>(
        solve_on_grid(problem, options.equation, scales, range,
                      static_cast<int>(std::lround(intervals)), time_step, start));
    if (!density->has_converged) {
      solution.status = Status::not_converged;
      solution.reason = fmt::format(
          "the iteration for the stationary density does not converge with {:.0f} intervals in y'",
          intervals);
      break;
    }
    start = [density](double y, double v) { return (*density)(y, v); };
    if (levels.empty()) {
      constexpr int kBins = 100;
      y_edges = uniform_breaks(density->range.y_begin, density->range.y_end, kBins);
      v_edges = uniform_breaks(-density->range.v_end, density->range.v_end, kBins);
    }
    solution = solution_on_grid(problem, options, density);
    levels.push_back(transform::make_grid_level(solution, y_edges, v_edges));
    if (levels.size() >= 3) {
      constexpr double kNegligible = 1e-6, kEnlargement = 1.25, kLargestFactor = 1.9;
      const auto extremes = density_extremes(walls, *density);
      if (extremes.near_ends > kNegligible * extremes.peak && range_factor < kLargestFactor) {
        range_factor *= kEnlargement;
        intervals = fewest * range_factor;
        levels.clear();
        continue;
      }
      // Interpolation creates probability at the growth rate, which spreads in the decay time.
      // The residual of the eigenvector leaves an error in the masses of wells.
      const double decay_per_repetition =
          -std::expm1(-scales.slowest_decay_rate * kPhaseOfRepetition / scales.frequency);
      const double defect = std::abs(density->growth_rate) / scales.slowest_decay_rate +
                            kEigenvectorTolerance / decay_per_repetition;
      // The splitting is of the order 2, and 4 after the extrapolation. At walls with losses the
      // density jumps, and at kinks of the force its slope jumps: the observed order is 1 to 2.
      const bool is_smooth =
          !has_impact_losses(problem.system) && !has_kinks(problem, density->range);
      const int scheme_order = is_smooth ? 4 : 2;
      solution.error = error_estimate(levels, scheme_order, defect);
      const double error = std::max(solution.error->y_l1, solution.error->ydot_l1);
      solution.status = Status::ok;
      if ((error <= kTargetError && !options.intervals) ||
          std::lround(intervals * kRatio) > std::lround(finest * range_factor))
        break;
    }
    intervals *= kRatio;
  }
  if (solution.status == Status::ok) {
    transform::require_accuracy(
        options.accuracy,
        fmt::format("the estimated L1 error is {:.2g} in p(y) and {:.2g} in p(y')",
                    solution.error->y_l1, solution.error->ydot_l1),
        solution);
  }
  solution.seconds = stopwatch.seconds();
  return solution;
}

std::string unsupported_reason(const problem::Problem& problem,
                               const PathIntegrationOptions& options) {
  const problem::ProblemFeatures features = problem::problem_features(problem);
  if (features.rests_in_contact && options.equation == problem::DensityEquation::kf) {
    return "the mass comes to rest at a wall: path integration has no atom; use fd or mcs";
  }
  if (problem.system.has_force_jumps_in_v()) {
    return "the force jumps in y': the motion without excitation comes to rest; use fd or mcs";
  }
  if (problem.noise_factor && problem.noise_factor->depends_on_v()) {
    return "the noise factor depends on y': the short-time law has a noise factor of y alone; use "
           "fd or mcs";
  }
  return problem::inelastic_collapse_reason(problem, options.equation);
}

}  // namespace fpkcheck::path_integration
