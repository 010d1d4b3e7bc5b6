#include "mcs/simulation/general_plan.hpp"

#include <fmt/format.h>

#include <string>

#include "base/input_error.hpp"
#include "mcs/applicability.hpp"
#include "problem/features.hpp"

namespace fpkcheck::mcs {
namespace {

// Intervals between kicks in radians. At strong impact losses the noise near the wall determines
// the motion, and the kicks must resolve this noise (measurements: docs/simulation.md).
constexpr double kAutomaticKickStep = 0.2, kKickStepWithStrongLosses = 0.05;
constexpr double kStrongLosses = 0.6;

double automatic_kick_step(const problem::System& system) {
  const auto has_strong_losses = [](const std::optional<problem::Wall>& wall) {
    return wall && wall->restitution < kStrongLosses;
  };
  return has_strong_losses(system.left_wall()) || has_strong_losses(system.right_wall())
             ? kKickStepWithStrongLosses
             : kAutomaticKickStep;
}

}  // namespace

GeneralPlan make_general_plan(const problem::Problem& problem, const Options& options) {
  if (options.deposit) {
    throw InputError("mcs.deposit outside the paper's class: not supported; omit mcs.deposit");
  }
  if (options.tails) {
    if (const std::string why = unsupported_splitting_reason(problem, options); !why.empty()) {
      throw InputError(fmt::format("mcs.tails: {}; omit mcs.tails", why));
    }
  }
  const bool white = options.equation == Equation::white;
  const double diffusion =
      problem.noise.diffusion() + (white ? problem.impulses.rate_times_moment(2) / 2 : 0);
  const auto scales = problem::scales(problem);
  const auto features = problem::features(problem);
  return {.scales = scales,
          .oscillator = make_general_oscillator(
              problem, scales, white ? problem.impulses.rate_times_moment(1) : 0, diffusion > 0),
          .kicks = noise_kicks(problem, scales, diffusion,
                               options.white_step.value_or(automatic_kick_step(problem.system))),
          .power = problem::total_intensity(problem) / 2,
          .has_contact_atoms = features.rests_in_contact && diffusion == 0,
          .wells = features.wells};
}

}  // namespace fpkcheck::mcs
