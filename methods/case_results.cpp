#include "methods/case_results.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "backward/residual/density_error_estimator.hpp"
#include "base/input_error.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stopwatch.hpp"
#include "methods/run_cases.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::methods {

std::vector<results::CaseResult> compute_case_results(const std::vector<problem::Problem>& problems,
                                                      const std::vector<Method>& methods,
                                                      const CaseResultSettings& settings) {
  const auto poll = [&] {
    if (settings.poll) settings.poll();
  };
  // All methods share the error estimators, so that each backward equation is solved only once.
  const auto estimators = make_error_estimators(problems);
  auto cases = run_cases(problems, methods, settings.threads, settings.progress, estimators,
                         settings.case_listener);
  poll();
  if (!settings.with_backward) return cases;
  // The cases run in parallel, since the fits of the backward equation are serial.
  const int threads = base::resolve_thread_count(settings.threads);
  const int cases_at_once = std::clamp(static_cast<int>(cases.size()), 1, threads);
  base::parallel_for(cases.size(), cases_at_once, [&](std::size_t k) {
    poll();
    constexpr double kSeconds = 1;  // time of all processors in which most problems reach grid 3
    cases[k].bounds =
        compute_guaranteed_bounds(cases[k].problem, {.relative_half_width = 1e-5,
                                                     .time_limit_seconds = kSeconds * cases_at_once,
                                                     .threads = threads / cases_at_once});
    poll();
    add_moment_error_estimates(cases[k], estimators[k], threads / cases_at_once);
    if (settings.case_listener) settings.case_listener(cases[k]);
  });
  poll();
  return cases;
}

compare::GuaranteedBounds compute_guaranteed_bounds(const problem::Problem& problem,
                                                    const backward::BoundsOptions& options) {
  const base::Stopwatch stopwatch;
  compare::GuaranteedBounds bounds{.reason = {}, .seconds = 0, .each = {}};
  const bool completed = run_unless_out_of_memory([&] {
    const backward::GuaranteedBounds computed =
        backward::compute_guaranteed_bounds(problem, options);
    bounds.reason = computed.reason;
    for (const auto& [functional, value] : computed.functional_bounds) {
      bounds.each.push_back({backward::functional_name(functional), value.lower, value.upper});
    }
  });
  if (!completed) bounds = {.reason = kOutOfMemory, .seconds = 0, .each = {}};
  bounds.seconds = stopwatch.seconds();
  return bounds;
}

namespace {

using results::CaseResult;
using transform::Moments;

struct MomentErrorsAndSources {
  results::MomentErrorEstimate error;
  std::vector<results::MomentErrorSource> sources;
};

results::MomentErrorSource make_error_source(const backward::DensityErrorEstimator& error_estimator,
                                             const problem::WallFrame& frame,
                                             const std::string& solution,
                                             const transform::NamedMoment& moment,
                                             const Eigen::MatrixXd& contributions,
                                             const transform::GridDensity& cells) {
  Eigen::MatrixXd values = error_estimator.distribute_contributions_over_cells(
      contributions, transform::wall_coordinate_edges(frame, cells.y_edges),
      transform::transform_v_edges(frame, cells.v_edges));
  if (frame.mirrored) values = values.reverse().eval();
  results::MomentErrorSource result{solution, moment.name, {cells.y_edges, cells.v_edges, {}}};
  for (const auto& row : values.rowwise()) {
    // Error sources are rounded to single precision, the precision of joint.nc.
    for (const double value : row) {
      result.density.averages.push_back(static_cast<float>(value));
    }
  }
  return result;
}

/// @param cells cells of the error sources; null if no error sources are computed
std::optional<MomentErrorsAndSources> estimate_moment_errors(
    const backward::DensityErrorEstimator& error_estimator, const problem::WallFrame& frame,
    const transform::Solution& solution, const transform::GridDensity* cells) try {
  const auto weighted =
      error_estimator.estimate_errors(transform::to_wall_coordinates(frame, *solution.density));
  MomentErrorsAndSources found{.error = {solution.id(), weighted.corrected_moments, {}},
                               .sources = {}};
  for (std::size_t k = 0; k < backward::kMomentCount; ++k) {
    const auto& named = transform::kMoments[k];
    found.error.error.*named.moment =
        solution.moments.*named.moment - weighted.corrected_moments.*named.moment;
    const bool has_error_source = named.moment == &Moments::y2 || named.moment == &Moments::v2;
    if (!has_error_source || cells == nullptr) continue;
    found.sources.push_back(make_error_source(error_estimator, frame, solution.id(), named,
                                              weighted.moment_error_contributions[k], *cells));
  }
  return found;
} catch (const InputError&) {
  return std::nullopt;  // no error estimate for a density without a mean
}

}  // namespace

void add_moment_error_estimates(CaseResult& case_result, const ResidualErrorEstimator& estimator,
                                int thread_count) {
  std::vector<const transform::Solution*> densities;
  for (const auto& solution : case_result.solutions) {
    if (solution.density && solution.identity.role != transform::SolutionRole::simulation) {
      densities.push_back(&solution);
    }
  }
  if (densities.empty()) return;
  const auto* cells = case_result.joints.empty() ? nullptr : &case_result.joints.front().density;
  std::vector<std::optional<MomentErrorsAndSources>> found(densities.size());
  const bool completed = run_unless_out_of_memory([&] {
    const auto* error_estimator = estimator.density_error_estimator();
    if (error_estimator == nullptr) return;
    base::parallel_for(densities.size(), thread_count, [&](std::size_t k) {
      found[k] = estimate_moment_errors(*error_estimator, estimator.wall_coordinates(),
                                        *densities[k], cells);
    });
  });
  if (!completed) return;
  for (auto& each : found) {
    if (!each) continue;
    case_result.moment_error_estimates.push_back(std::move(each->error));
    std::ranges::move(each->sources, std::back_inserter(case_result.error_sources));
  }
}

}  // namespace fpkcheck::methods
