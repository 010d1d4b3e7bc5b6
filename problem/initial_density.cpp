#include "problem/initial_density.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::problem {

Gaussian initial_density(const Problem& problem, const MotionScales& scales,
                         const InitialDensityOptions& options) {
  constexpr double kDefault = 0.5;
  Gaussian start{.displacement_deviation = options.displacement_deviation.value_or(
                     kDefault * scales.displacement_deviation),
                 .velocity_deviation =
                     options.velocity_deviation.value_or(kDefault * scales.velocity_deviation),
                 .mean_displacement = has_equivalent_linearisation(problem) ? 0 : scales.centre};
  // The mean displacement in a symmetric well is 0 up to rounding errors.
  constexpr double kRounding = 1e-12;
  if (std::abs(start.mean_displacement) < kRounding * start.displacement_deviation) {
    start.mean_displacement = 0;
  }
  const WallFrame& frame = problem.frame;
  if (const auto& y = options.mean_displacement) start.mean_displacement = frame.wall_x(*y);
  if (const auto& v = options.mean_velocity) start.mean_velocity = frame.physical_velocity(*v);
  const auto &left = problem.system.left_wall(), &right = problem.system.right_wall();
  if ((left && start.mean_displacement < left->position) ||
      (right && start.mean_displacement > right->position)) {
    throw InputError(
        fmt::format("start-mean-y = {:.6g}: behind a wall; choose a value between the walls",
                    frame.physical_y(start.mean_displacement)));
  }
  return start;
}

}  // namespace fpkcheck::problem
