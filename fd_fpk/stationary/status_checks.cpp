#include "fd_fpk/stationary/status_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fpkcheck::fd_fpk {
namespace {

// Returns a text with the ends of y that are not impact walls, such as "-2 <= y <= 3, " or "y <= 3,
// "; empty if both ends are impact walls.
std::string box_ends_text(const problem::WallFrame& frame, const GridAxis& x1) {
  bool low = x1.left_end_condition() == AxisEndCondition::vacuum,
       high = x1.right_end_condition() == AxisEndCondition::vacuum;
  double from = frame.physical_y(x1.faces().front()), to = frame.physical_y(x1.faces().back());
  if (frame.mirrored) {
    std::swap(low, high);
    std::swap(from, to);
  }
  if (low && high) return fmt::format("{:.3g} <= y <= {:.3g}, ", from, to);
  if (high) return fmt::format("y <= {:.3g}, ", to);
  return low ? fmt::format("y >= {:.3g}, ", from) : "";
}

}  // namespace

std::string small_box_failure_reason(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                                     const BoxEdgeDensity& wall, const std::string& when) {
  if (wall.x1 <= kMaxBoxEdgeDensity && wall.x2 <= kMaxBoxEdgeDensity &&
      wall.x1_low <= kMaxBoxEdgeDensity)
    return "";
  return fmt::format(
      "the box {}|y'| <= {:.3g} is too small: {}the density on its wall is {:.1e} of the peak; "
      "increase y-max and v-max",
      box_ends_text(frame, grid.x1), grid.x2_max(), when,
      std::max({wall.x1, wall.x2, wall.x1_low}));
}

using transform::Status;

void check_box_size(const problem::WallFrame& frame, const PhasePlaneGrid& grid,
                    FiniteVolumeResult& result) {
  auto& [solution, summary] = result;
  if (solution.status != Status::ok) return;
  solution.reason = small_box_failure_reason(frame, grid, summary.wall);
  if (!solution.reason.empty()) solution.status = Status::failed;
}

void check_resolution(const FiniteVolumeOptions& options, FiniteVolumeResult& result) {
  auto& solution = result.solution;
  if (solution.status != Status::ok) return;
  if (!kStationaryResolutionLimits.is_density_accepted(solution.min_density)) {
    const bool first_order_impact = options.impact == ImpactCondition::delta;
    solution.reason = fmt::format(
        "the density is negative, {:.1g} of its peak: {}", solution.min_density,
        first_order_impact
            ? "the grid is too coarse, or the first-order impact has no nonnegative "
              "density; compare with a finer grid"
            : "the grid does not resolve it; refine the grid with nx and nv, or use mcs");
  } else if (std::abs(solution.energy_residual) >
                 std::max(kStationaryResolutionLimits.power, options.accuracy) ||
             std::isnan(solution.energy_residual)) {
    solution.reason = fmt::format(
        "the power balance has a residual of {:.1g} of the input: the grid does not resolve the "
        "density; refine the grid with nx and nv, or use mcs",
        solution.energy_residual);
  }
  if (!solution.reason.empty()) solution.status = Status::inadmissible;
}

void check_balances(FiniteVolumeResult& result) {
  auto& [solution, summary] = result;
  if (solution.status != Status::ok) return;
  const std::pair<const char*, double> balances[] = {
      {"power", solution.energy_residual},
      {"virial", summary.balances.virial.value_or(0)},
      {"momentum", summary.balances.momentum.value_or(0)}};
  const double limit = kMaxBalanceResidual * summary.exchanged_power;
  for (const auto& [name, residual] : balances) {
    if (std::abs(residual) <= limit) continue;
    solution.status = Status::inaccurate;
    solution.reason = fmt::format(
        "the {} balance has a residual of {:.1g}, more than {:.1g}; increase max-seconds", name,
        std::abs(residual), limit);
    return;
  }
}

void check_error_estimate(const FiniteVolumeOptions& options, FiniteVolumeResult& result) {
  auto& [solution, summary] = result;
  if (solution.status != Status::ok) return;
  if (!summary.error) {
    solution.status = Status::inaccurate;
    solution.reason =
        "the discretisation error is unknown: two coarser grids with a density are missing; refine "
        "the grid or increase max-seconds";
    return;
  }
  const double l1 = std::max(summary.error->y_l1, summary.error->ydot_l1);
  if (l1 <= options.accuracy) return;
  solution.status = Status::inaccurate;
  solution.reason = fmt::format(
      "the estimated discretisation error is {:.2g} in L1 (observed order {:.1f}), requested {:g}; "
      "increase max-seconds or accuracy",
      l1, summary.error->observed_order, options.accuracy);
}

}  // namespace fpkcheck::fd_fpk
