#include "fd_fpk/functionals/grid_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "base/process/parallel_for.hpp"
#include "fd_fpk/operator/well_posedness.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/error_estimate.hpp"
#include "transform/richardson.hpp"

namespace fpkcheck::fd_fpk {
namespace {

struct TimedFunctionalValuesOnGrid : FunctionalValuesOnGrid {
  double seconds = 0;
};

// Sets the differences between the last grids, and the error estimates.
void estimate_errors(const std::vector<TimedFunctionalValuesOnGrid>& levels,
                     const Eigen::VectorXd& scales, int order,
                     FunctionalValuesFromGridSequence& result) {
  const std::size_t n = levels.size();
  result.last_difference = (levels[n - 1].values - levels[n - 2].values).cwiseAbs();
  if (n >= 3) {
    result.previous_difference = (levels[n - 2].values - levels[n - 3].values).cwiseAbs();
  }
  result.errors =
      error_estimates(result.previous_difference, result.last_difference, scales, order);
}

}  // namespace

Eigen::VectorXd error_estimates(const Eigen::VectorXd& previous_difference,
                                const Eigen::VectorXd& last_difference,
                                const Eigen::VectorXd& scales, int order) {
  const double q = transform::kRefinementRatio;
  if (previous_difference.size() == 0) {
    return last_difference * (transform::kErrorSafetyFactor / (q - 1));
  }
  const auto span = [](const Eigen::VectorXd& values) {
    return std::span(values.data(), static_cast<std::size_t>(values.size()));
  };
  const std::vector<double> errors = transform::errors_with_common_order(
      span(previous_difference), span(last_difference), span(scales), q, order);
  return Eigen::Map<const Eigen::VectorXd>(errors.data(), std::ssize(errors));
}

FunctionalValuesFromGridSequence refine_grids_until_converged(
    const std::function<FunctionalValuesOnGrid(double refinement)>& evaluate_on_grid, int order,
    double tolerance, const MagnitudeFunction& magnitudes, const base::Deadline& deadline) {
  constexpr double q = transform::kRefinementRatio;
  // Ratio of the computing times on successive grids
  constexpr double kTimeRatio = 3;
  const auto timed = [&](double refinement) {
    const base::Stopwatch stopwatch;
    TimedFunctionalValuesOnGrid level{evaluate_on_grid(refinement)};
    level.seconds = stopwatch.seconds();
    return level;
  };
  FunctionalValuesFromGridSequence result;
  std::vector<TimedFunctionalValuesOnGrid> levels(2);
  base::parallel_for(2, base::kOneThreadPerProcessor,
                     [&](std::size_t k) { levels[k] = timed(k == 0 ? 1 / (q * q) : 1 / q); });
  const auto failed = std::ranges::find_if(
      levels, [](const TimedFunctionalValuesOnGrid& level) { return level.values.size() == 0; });
  if (failed != levels.end()) {
    result.failure = failed->failure;
    return result;
  }
  for (double refinement = 1;; refinement *= q) {
    const TimedFunctionalValuesOnGrid& finest = levels.back();
    result.values = finest.values;
    result.nx = finest.nx;
    result.nv = finest.nv;
    const Eigen::VectorXd scales = magnitudes(finest.values);
    estimate_errors(levels, scales, order, result);
    result.reached =
        levels.size() >= 3 && (result.errors.array() <= tolerance * scales.array()).all();
    if (result.reached) return result;
    if (levels.size() >= 3 && !deadline.has_time_for(kTimeRatio * finest.seconds)) {
      result.failure = "max_seconds would expire on a finer grid; increase max-seconds";
      return result;
    }
    TimedFunctionalValuesOnGrid next = timed(refinement);
    if (next.values.size() == 0) {  // `result` keeps the values of the coarser grids
      result.failure = next.failure;
      return result;
    }
    levels.push_back(std::move(next));
  }
}

FunctionalValuesFromGridSequence refine_grids_until_converged(
    const problem::Problem& problem, const FiniteVolumeOptions& options, double tolerance,
    const StationaryFunctionals& functionals, const MagnitudeFunction& magnitudes) {
  // All grids have the same box, so that the differences between grids do not contain the
  // truncation error of the box. The box of functionals is therefore wider than the box of a
  // stationary density. In case 1, a box wider than the box of functionals changes E[y'^4] by a
  // relative 6e-7, and the derivatives of E[y'^4] with respect to the parameters by a relative
  // 4e-6. With the box of a stationary density the relative changes are 2e-5 and 1e-4 (`fpkcheck
  // sensitivity case1 --methods fd-kf`).
  constexpr double kEdgeDensityFactor = 1e-2;
  const base::Deadline deadline(options.max_seconds);
  FiniteVolumeOptions on_grid = options;
  on_grid.wall_density *= kEdgeDensityFactor;
  on_grid.order = options.order.value_or(automatic_scheme_order(problem));
  MotionScalesAndComputationalBox scales_and_box{.scales = problem::motion_scales(problem)};
  if (!has_linearised_scales(problem)) on_grid.wall_density *= box_edge_density_factor(problem);
  scales_and_box.box = stationary_box(problem, scales_and_box.scales, on_grid, deadline);
  on_grid.x1_max = scales_and_box.box->x1_max;
  on_grid.x2_max = scales_and_box.box->x2_max;

  const PlaneDiscretisation first =
      discretise_density_equation(problem, on_grid, *scales_and_box.box);
  std::string failure = first.failure;
  if (failure.empty()) failure = check_well_posedness(problem, on_grid, first).ill_posed_reason;
  if (!failure.empty()) return {.failure = failure};

  const auto evaluate_on_grid = [&](double refinement) -> FunctionalValuesOnGrid {
    DirectStationarySolution direct_solution = compute_direct_solution(
        problem, scales_and_box, with_refined_cells(on_grid, refinement), deadline);
    FunctionalValuesOnGrid level{.nx = direct_solution.discretisation.grid.nx(),
                                 .nv = direct_solution.discretisation.grid.v_cell_count()};
    if (direct_solution.averages && !direct_solution.converged) {
      level.failure = "GMRES did not find the stationary density; use another grid";
    } else if (direct_solution.averages) {
      level.values = functionals(direct_solution, deadline, level.failure);
    } else {
      level.failure = direct_solution.failure;
    }
    return level;
  };
  return refine_grids_until_converged(evaluate_on_grid, transport_order(on_grid), tolerance,
                                      magnitudes, deadline);
}

}  // namespace fpkcheck::fd_fpk
