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
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::mcs {
namespace {

// Durations of simulations and of burn-ins, in units of the decay time of the slowest mode
constexpr double kAutomaticTime = 1.6e6;
constexpr double kBurnIn = 20;      // 20 decay times leave exp(-20) of the initial deviation
constexpr double kLeastBurnIn = 5;  // shortest burn-in of a converged solution
// 99 % quantile of the L1 sampling error of p(y) or p(y'), times the square root of the simulated
// time in decay times. The product of quantile and square root is 0.6 to 2.3 in the shipped cases
// with a single potential well and without strong impact losses, and at most 4.3 in all other
// shipped cases (`fpkcheck mcs CASE --json`, keys sampling_l1 and time).
constexpr double kErrorOfOneDecayTime = 2.5;

// Factor of the default simulated time for importance splitting, which multiplies the work
constexpr double kTailsShare = 1.0 / 32;
// Factor of the default simulated time for control variates, which gives L1 errors over smooth bins
// of 3e-6 to 1e-5 in the cases of the paper, at most a third of the errors of finite volumes.
constexpr double kControlledShare = 1.0 / 32;

// Limits of the number of impulses and flights in all trajectory streams. One processor simulates
// 2e7 to 3e7 impulses and flights per second. The limit of the number of events in a default
// simulation corresponds to a few seconds of computing with flights other than DuffingFlights.
constexpr double kDefaultEvents = 4e7;
constexpr double kMostRunEvents = 2e9;  // limit for any run: about one minute of computing
// Limit of the number of impulses and flights of the main branches under importance splitting, for
// half a minute of computing (`fpkcheck_random --tails --family --count 40`). The branches that
// importance splitting starts are up to 17 times as numerous as main branches, have more flights
// per unit time, and leave half of the SIMD lanes idle.
constexpr double kMostTrunkEvents = 2.5e6;

// Limit of the simulated time with SimulationOptions::samples or SimulationOptions::target_error,
// as a multiple of the default simulated time
constexpr double kMostAutomaticTimes = 1e4;
// Longest burn-in, summed over all trajectory streams, as a fraction of the default simulated time
constexpr double kLongestBurnIn = 1.0 / 8;

struct TrajectoryEventRates {
  double decay;  ///< decay rate of the slowest mode
  double impulses;
  double flights;  ///< rate of flights, plus the rate of noise kicks that act besides impulses
  /// Whether the flights are DuffingFlights, which need about half of the time of other flights
  bool duffing_flights = true;
  int wells = 1;

  double total_rate() const { return impulses + flights; }
};

double default_simulated_time(const SimulationOptions& options, const TrajectoryEventRates& rates) {
  const double share = options.tails ? kTailsShare : options.controlled ? kControlledShare : 1;
  const double full = kAutomaticTime * share / rates.decay;
  const double most = (options.tails ? kMostTrunkEvents : kMostRunEvents) / rates.total_rate();
  const double default_time =
      rates.duffing_flights
          ? most
          : kDefaultEvents * (options.tails ? kTailsShare : 1) / rates.total_rate();
  const double enough = std::pow(kErrorOfOneDecayTime / options.accuracy, 2) / rates.decay;
  // Whether SimulationOptions::accuracy requires more simulated time than the largest default
  // simulated time `full`, or, with several potential wells, more than a minute of computing.
  const bool is_out_of_reach = enough > full || (enough > most && rates.wells > 1);
  return std::min(full,
                  is_out_of_reach ? default_time : std::max(default_time, std::min(enough, most)));
}

double burn_in_time(const SimulationOptions& options, const TrajectoryEventRates& rates,
                    double automatic, double time) {
  return std::min(kBurnIn / rates.decay,
                  std::max(kLongestBurnIn * automatic, time) / options.streams);
}

struct SimulationDurations {
  double automatic;  ///< default simulated time, summed over all streams
  double time;       ///< upper limit of the simulated time, summed over all streams
  double burn_in;
  ShortBurnInCause short_burn_in_cause;
};

/// Chooses the simulated time and the burn-in. The full simulated time is 1.6e6 decay times,
/// reduced as in SimulationOptions::time, with L1 sampling errors of p(y) and p(y') of about 6e-4.
/// The default simulated time is the full simulated time if the computation takes at most a minute
/// with DuffingFlights, or a few seconds with other flights. If the full simulated time would need
/// more computing time, the simulation takes a few seconds, or up to a minute if
/// SimulationOptions::accuracy requires a longer simulation. With several potential wells and rare
/// transitions even a minute of computing would not determine the probabilities of the wells, and
/// the simulation takes only a few seconds.
SimulationDurations choose_durations(const SimulationOptions& options,
                                     const TrajectoryEventRates& rates) {
  const double automatic = default_simulated_time(options, rates);
  const bool open_ended = options.samples || options.target_error;
  const double time = options.time.value_or(automatic * (open_ended ? kMostAutomaticTimes : 1));
  SimulationDurations durations{.automatic = automatic,
                                .time = time,
                                .burn_in = burn_in_time(options, rates, automatic, time),
                                .short_burn_in_cause = ShortBurnInCause::none};
  const auto is_long_enough = [&](double taken) { return taken * rates.decay >= kLeastBurnIn; };
  if (is_long_enough(durations.burn_in)) return durations;
  TrajectoryEventRates without = rates;
  without.impulses = 0;
  const double of_motion = default_simulated_time(options, without);
  durations.short_burn_in_cause =
      is_long_enough(burn_in_time(options, without, of_motion, options.time.value_or(of_motion)))
          ? ShortBurnInCause::impulses
      : rates.wells > 1 ? ShortBurnInCause::wells
                        : ShortBurnInCause::decay;
  return durations;
}

constexpr double kMostSamples = 1e15;  // largest number of samples per stream

constexpr int kAutomaticBins = 140;
// Default interval between the evenly spaced kicks that replace white noise, in radians
constexpr double kAutomaticWhiteStep = 0.05;
// With 50 instead of 25 samples per period of the oscillation, the sampling errors of the bins
// would be smaller by 1/7, at a higher cost.
constexpr double kSamplesPerPeriod = 25;
// Progress reports and interruptions of a simulation occur between rounds. A round takes the least
// of 1/40 of the default simulated time, 1/8 of the requested simulated time, and about 0.1 s of
// computing time.
constexpr double kAutomaticRounds = 40;
constexpr double kFewestRounds = 8;
// Largest number of impulses and flights of all trajectory streams in one round of the simulation
constexpr double kMostEvents = 2e7;

std::vector<double> evenly_spaced_edges(double from, double to) {
  std::vector<double> edges;
  for (int k = 0; k <= kAutomaticBins; ++k) {
    edges.push_back(from + (to - from) * k / kAutomaticBins);
  }
  return edges;
}

BinFinder make_bin_finder(const std::vector<double>& edges, double from, double to) {
  return BinFinder(edges.empty() ? evenly_spaced_edges(from, to) : edges);
}

struct SimulationRoundCounts {
  std::uint64_t samples, rounds;
};

/// @param events number of impulses, kicks and flights per unit time
SimulationRoundCounts choose_rounds(const SimulationOptions& options,
                                    const SimulationDurations& durations, double interval,
                                    double events) {
  const double time = durations.time;
  const double simulated_time_per_round = std::min(
      {durations.automatic / kAutomaticRounds, time / kFewestRounds, kMostEvents / events});
  // The length of a sampling round is independent of the requested time, unless the requested time
  // is short. Because of the equal round lengths, a longer simulation can resume from the
  // checkpoint of a shorter simulation.
  const double samples =
      std::ceil(simulated_time_per_round / options.streams / interval * (1 - 1e-12));
  const double rounds = std::ceil(time / (samples * options.streams * interval) * (1 - 1e-12));
  if (!(samples >= 1 && samples * rounds <= kMostSamples)) {
    throw InputError(fmt::format(
        "mcs.time = {}: each of {} streams would have {:.0e} samples, at most {:.0e} are "
        "possible; reduce the time",
        time, options.streams, samples * rounds, kMostSamples));
  }
  return {static_cast<std::uint64_t>(samples), static_cast<std::uint64_t>(rounds)};
}

// Intervals between noise kicks in radians. With strong impact losses the noise near the wall
// determines the motion, and the noise kicks must resolve the motion near the wall (measurements:
// docs/simulation.md). With multiplicative noise the bias of Strang splitting in E[v^4] is of
// second order in the kick interval: 4e-3 at 0.5 rad, and 4e-5 at 0.05 rad, a tenth of the standard
// error of a simulation of default duration (test MultiplicativeNoise.*). For a force that jumps in
// v the density has a kink, which long kick intervals smooth: at the kick interval 0.2 rad, E[y^2]
// of the case coulomb is 3e-3 too large.
constexpr double kAutomaticKickStep = 0.2, kShortKickStep = 0.05;
constexpr double kStrongLosses = 0.6;

double default_kick_step(const problem::Problem& problem, const problem::MotionScales& scales) {
  const auto has_strong_losses = [&](const std::optional<problem::Wall>& wall) {
    if (!wall) return false;
    for (const double share : {0.0, 0.01, 0.1, 0.3, 1.0}) {
      if (wall->restitution_at_speed(share * scales.velocity_deviation) < kStrongLosses)
        return true;
    }
    return false;
  };
  return problem.noise_factor || problem.system.has_force_jumps_in_v() ||
                 has_strong_losses(problem.system.left_wall()) ||
                 has_strong_losses(problem.system.right_wall())
             ? kShortKickStep
             : kAutomaticKickStep;
}

/// Validates options for a problem: the bin edges of y must begin at 0 only for a Duffing
/// oscillator at a wall (is_duffing_at_wall()).
void validate_for_problem(const problem::Problem& problem, const SimulationOptions& options) {
  if (is_duffing_at_wall(problem)) return validate(options);
  if (!options.y_edges.empty()) require_increasing_edges("mcs.y_edges", options.y_edges);
  SimulationOptions others = options;
  others.y_edges.clear();
  validate(others);
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
}

/// Returns the impulses of the problem, or the evenly spaced kicks that replace the impulses as
/// white noise. If NoiseKicks replace the impulses by white noise, the interval between impulses is
/// infinite.
ImpulseProcess make_excitation(const problem::Problem& problem, const SimulationOptions& options,
                               const problem::MotionScales& scales) {
  const bool white = options.equation == DensityEquation::white;
  if (white && is_duffing_at_wall(problem)) {
    return white_noise_impulse_process(
        problem.impulses, options.white_step.value_or(kAutomaticWhiteStep) / scales.frequency);
  }
  ImpulseProcess excitation = poisson_impulse_process(problem.impulses);
  excitation.power = problem::total_excitation_intensity(problem) / 2;
  if (white || !problem.impulses.is_acting()) {
    excitation.interval = std::numeric_limits<double>::infinity();
    // The expected work of noise kicks alone is 0; see apply_noise_kick().
    excitation.work = 0;
  }
  return excitation;
}

}  // namespace

SimulationPlan make_simulation_plan(const problem::Problem& problem,
                                    const SimulationOptions& options) {
  validate_for_problem(problem, options);
  const bool duffing_at_wall = is_duffing_at_wall(problem);
  const problem::MotionScales scales = problem::motion_scales(problem);
  const problem::ProblemFeatures features = problem::problem_features(problem);
  // NoiseKicks replace the impulses as white noise, except for a Duffing oscillator at a wall.
  const bool by_kicks = options.equation == DensityEquation::white && !duffing_at_wall;
  const double diffusion =
      problem.noise.diffusion() + (by_kicks ? problem.impulses.rate_times_moment(2) / 2 : 0);
  const NoiseKicks kicks = make_noise_kicks(
      problem, scales, diffusion, options.white_step.value_or(default_kick_step(problem, scales)));
  const bool has_contact_atoms = features.rests_in_contact && !kicks.is_acting();
  const ImpulseProcess excitation = make_excitation(problem, options, scales);
  const double step = options.step.value_or(kAutomaticStepInRadians);
  // The frequency at the mean energy determines the sampling interval. If most of the probability
  // mass is at rest in contact, the frequency at the mean energy belongs to tiny bounces. The
  // impulse rate gives a lower limit of the sampling interval for motion that is mostly at rest.
  constexpr double kSamplesPerRest = 50;
  const double least =
      has_contact_atoms ? 1 / problem.impulses.arrival_rate() / kSamplesPerRest : 0;
  const double interval =
      std::max(2 * std::numbers::pi / scales.frequency / kSamplesPerPeriod, least);
  const double kick_rate = kicks.is_acting() ? 1 / kicks.longest_interval : 0;
  const SimulatedOscillator oscillator = make_oscillator(
      problem, scales, by_kicks ? problem.impulses.rate_times_moment(1) : 0, kicks.is_acting());
  // A FormulaFlight covers about a quarter of the simulated time of a PolynomialFlight.
  const double flights_per_step = oscillator.kind == SimulatedOscillator::Kind::formula ? 4 : 1;
  const TrajectoryEventRates rates{
      .decay = scales.slowest_decay_rate,
      .impulses = 1 / excitation.interval,
      .flights = kick_rate + flights_per_step * scales.frequency / step,
      .duffing_flights = duffing_at_wall,
      .wells = features.wells};
  const SimulationDurations durations = choose_durations(options, rates);
  const auto [samples, rounds] = choose_rounds(options, durations, interval, rates.total_rate());
  std::optional<SampleDepositionPlan> deposit;
  if (options.deposit) {
    deposit.emplace(*options.deposit, problem.impulses.arrival_rate(), interval);
  }
  return {
      .streams = options.streams,
      .threads = std::min(base::resolve_thread_count(options.threads.value_or(0)), options.streams),
      .seed = options.seed,
      .frame = problem.frame,
      .oscillator = oscillator,
      .kicks = kicks,
      .step = step,
      .expected_event_rate = rates.total_rate(),
      .burn_in = durations.burn_in,
      .short_burn_in_cause = durations.short_burn_in_cause,
      .sampling_interval = interval,
      .samples_per_round = samples,
      .rounds = rounds,
      .centre = scales.centre,
      .displacement_deviation = scales.displacement_deviation,
      .velocity_deviation = scales.velocity_deviation,
      .has_contact_atoms = has_contact_atoms,
      .excitation = excitation,
      .y_bins = make_bin_finder(options.y_edges, scales.y_low, scales.y_high),
      .v_bins = make_bin_finder(options.v_edges, -scales.v_high, scales.v_high),
      .deposit = deposit,
      .time = problem.time};
}

std::string short_burn_in_reason(const SimulationPlan& plan, const SimulationOptions& options) {
  const auto text = [&](const std::string& cause, const char* action) {
    return fmt::format("the burn-in of {:.2g} is below 5 decay times: {}; {}", plan.burn_in, cause,
                       action);
  };
  switch (plan.short_burn_in_cause) {
    case ShortBurnInCause::impulses:
      return text(fmt::format("impulses are frequent relative to the decay ({:.2g} per unit time)",
                              1 / plan.excitation.interval),
                  options.tails ? "increase --time"
                                : "increase --time, or use white noise (--equation white)");
    case ShortBurnInCause::wells:
      return text(
          "transitions between the wells are rare, and their masses may still be the "
          "initial ones",
          "increase --time");
    case ShortBurnInCause::decay:
      return text("the energy decays slowly", "increase --time");
    case ShortBurnInCause::none:
      break;
  }
  return "";
}

}  // namespace fpkcheck::mcs
