#include "mcs/simulation/simulation_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/input_error.hpp"
#include "base/process/parallel_for.hpp"
#include "mcs/applicability.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/features.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr double kMostSamples = 1e15;  // samples per stream

constexpr int kAutomaticBins = 140;
constexpr double kAutomaticExtent = 7;        // standard deviations
constexpr double kAutomaticWhiteStep = 0.05;  // radians
// 50 samples per period would reduce the sampling noise of the bins by a seventh, at a higher cost.
constexpr double kSamplesPerPeriod = 25;
// Progress reports and interruptions occur between rounds. A round takes the least of a fortieth of
// the default time, an eighth of the requested time, and about a tenth of a second.
constexpr double kAutomaticRounds = 40;
constexpr double kFewestRounds = 8;
constexpr double kMostEvents = 2e7;  // impulses and flights per round in all streams

std::vector<double> evenly_spaced(double from, double to) {
  std::vector<double> edges;
  for (int k = 0; k <= kAutomaticBins; ++k) {
    edges.push_back(from + (to - from) * k / kAutomaticBins);
  }
  return edges;
}

BinFinder bins(const std::vector<double>& edges, double from, double to) {
  return BinFinder(edges.empty() ? evenly_spaced(from, to) : edges);
}

struct Rounds {
  std::uint64_t samples, rounds;
};

/// @param events impulses, kicks and flights per unit time
Rounds choose_rounds(const Options& options, const Durations& durations, double interval,
                     double events) {
  const double time = durations.time;
  const double round_time = std::min(
      {durations.automatic / kAutomaticRounds, time / kFewestRounds, kMostEvents / events});
  // The length of a round is independent of the requested time, unless the requested time is short.
  // A longer simulation can therefore resume from the checkpoint of a shorter simulation.
  const double samples = std::ceil(round_time / options.streams / interval * (1 - 1e-12));
  const double rounds = std::ceil(time / (samples * options.streams * interval) * (1 - 1e-12));
  if (!(samples >= 1 && samples * rounds <= kMostSamples)) {
    throw InputError(fmt::format(
        "mcs.time = {}: each of {} streams would have {:.0e} samples, at most {:.0e} are "
        "possible; reduce the time",
        time, options.streams, samples * rounds, kMostSamples));
  }
  return {static_cast<std::uint64_t>(samples), static_cast<std::uint64_t>(rounds)};
}

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

GeneralPlan make_general_plan(const problem::Problem& problem, const Options& options) {
  if (options.deposit) {
    throw InputError(
        "mcs.deposit: supported only for one wall at y = 0, damping c y', force k y + mu y^3 and "
        "impulses alone; omit mcs.deposit");
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

/// Checks the options of a problem whose domain is not y >= 0: bin edges may begin anywhere.
void validate_for_any_domain(const Options& options) {
  if (!options.y_edges.empty()) require_edges("mcs.y_edges", options.y_edges);
  Options others = options;
  others.y_edges.clear();
  validate(others);
}

/// Properties of a motion and its excitation that determine the plan of its simulation.
struct PlanInputs {
  double sampling_interval;
  double step;
  EventRates rates;
  double displacement_deviation, velocity_deviation;
  Excitation excitation;
  double y_low, y_high, v_high;  ///< ends of the automatic bins
  std::optional<DepositPlan> deposit{};
  std::optional<GeneralPlan> general{};
};

PlanInputs inputs_of_general_motion(const problem::Problem& problem, const Options& options) {
  validate_for_any_domain(options);
  const GeneralPlan general = make_general_plan(problem, options);
  const auto& s = general.scales;
  // The sampling interval follows from the frequency at the mean energy. If the mass is mostly at
  // rest in contact, this frequency is that of tiny bounces. The rate of impulses then gives a
  // lower limit of the sampling interval.
  constexpr double kSamplesPerRest = 50;
  const double least =
      general.has_contact_atoms ? 1 / problem.impulses.arrival_rate() / kSamplesPerRest : 0;
  const double step = options.step.value_or(kAutomaticStep);
  const double kicks = general.kicks.is_present() ? 1 / general.kicks.longest_interval : 0;
  const bool white = options.equation == Equation::white;
  const double impulses = white ? 0 : problem.impulses.arrival_rate();
  Excitation excitation = poisson_excitation(problem.impulses);
  excitation.power = general.power;
  if (impulses == 0) {
    excitation.interval = std::numeric_limits<double>::infinity();
    // The expected work of the kicks alone is 0; see apply_kick().
    excitation.work = 0;
  }
  return {
      .sampling_interval = std::max(2 * std::numbers::pi / s.frequency / kSamplesPerPeriod, least),
      .step = step,
      .rates = {.decay = s.slowest_decay_rate,
                .impulses = impulses,
                .flights = kicks + s.frequency / step,
                .any_oscillator = true,
                .wells = general.wells},
      .displacement_deviation = s.displacement_deviation,
      .velocity_deviation = s.velocity_deviation,
      .excitation = excitation,
      .y_low = s.y_low,
      .y_high = s.y_high,
      .v_high = s.v_high,
      .general = general};
}

PlanInputs inputs_of_energy_bounded_motion(const problem::Problem& problem,
                                           const Options& options) {
  validate(options);
  const auto linear = problem::equivalent_linearisation(problem);
  const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
  const double frequency = std::sqrt(linear.stiffness);
  const double interval = 2 * std::numbers::pi / frequency / kSamplesPerPeriod;
  const Excitation excitation =
      options.equation == Equation::white
          ? white_noise_excitation(problem.impulses,
                                   options.white_step.value_or(kAutomaticWhiteStep) / frequency)
          : poisson_excitation(problem.impulses);
  const double step = options.step.value_or(kAutomaticStep);
  std::optional<DepositPlan> deposit;
  if (options.deposit) {
    deposit.emplace(*options.deposit, problem.impulses.arrival_rate(), interval);
  }
  return {.sampling_interval = interval,
          .step = step,
          .rates = {.decay = problem::slowest_decay_rate(linear),
                    .impulses = 1 / excitation.interval,
                    .flights = frequency / step},
          .displacement_deviation = s1,
          .velocity_deviation = s2,
          .excitation = excitation,
          .y_low = 0,
          .y_high = problem::static_deflection(problem) + kAutomaticExtent * s1,
          .v_high = kAutomaticExtent * s2,
          .deposit = deposit};
}

}  // namespace

SimulationPlan make_simulation_plan(const problem::Problem& problem, const Options& options) {
  // The fast motion (Oscillator, MotionParameters) needs one wall, at the equilibrium, and an
  // energy that does not grow between impulses: constant damping c > 0, no noise, a force k y + mu
  // y^3.
  const PlanInputs inputs = problem::has_equivalent_linearisation(problem)
                                ? inputs_of_energy_bounded_motion(problem, options)
                                : inputs_of_general_motion(problem, options);
  const Durations durations = choose_durations(options, inputs.rates);
  const auto [samples, rounds] =
      choose_rounds(options, durations, inputs.sampling_interval, inputs.rates.total_rate());
  return {
      .streams = options.streams,
      .threads = std::min(base::number_of_threads(options.threads.value_or(0)), options.streams),
      .seed = options.seed,
      .frame = problem.frame,
      .step = inputs.step,
      .burn_in = durations.burn_in,
      .short_burn_in_cause = durations.short_burn_in_cause,
      .sampling_interval = inputs.sampling_interval,
      .samples_per_round = samples,
      .rounds = rounds,
      .displacement_deviation = inputs.displacement_deviation,
      .velocity_deviation = inputs.velocity_deviation,
      .excitation = inputs.excitation,
      .y_bins = bins(options.y_edges, inputs.y_low, inputs.y_high),
      .v_bins = bins(options.v_edges, -inputs.v_high, inputs.v_high),
      .deposit = inputs.deposit,
      .general = inputs.general};
}

}  // namespace fpkcheck::mcs
