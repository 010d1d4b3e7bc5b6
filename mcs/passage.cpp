#include "mcs/passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <variant>

#include "base/process/parallel_for.hpp"
#include "base/process/stopwatch.hpp"
#include "mcs/applicability.hpp"
#include "mcs/estimate/kick_interval_error.hpp"
#include "mcs/passage/level_crossings.hpp"
#include "mcs/passage/probability_estimate.hpp"
#include "mcs/passage/rare_passages.hpp"
#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "problem/effective_potential.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::Status;
using transform::ValueWithError;

constexpr double kSamplesPerPeriod = 60;
// Relative standard error of the mean passage time at which the simulation ends. The simulated time
// is limited by the number of periods and by the number of impulses, kicks and flights, both summed
// over all streams; the limits correspond to about 10 s of computing.
constexpr double kGoal = 0.01, kMostPeriods = 3e6, kMostPassageEvents = 9e7;
// Least number of stays for a result, and least number of stays for an end of the simulation at
// kGoal: stays are correlated, and a standard error computed from few stays may be accidentally
// small.
constexpr double kFewestStays = 100, kFewestStaysAtGoal = 1000;
constexpr double kMostRecords = 1e5;  // largest number of stored records of a stream in a round
constexpr int kRounds = 50;           // number of rounds of the longest simulation
// Time, in decay times of the slowest mode, after which the hazard is treated as constant
constexpr double kDecayTimes = 3;
// The same time with splitting, in which all stays end at this time
constexpr double kDecayTimesOfRareStays = 6;
// Part of the longest simulation after which splitting replaces the simulation if the simulation
// would not reach kGoal: 1/kTrials
constexpr std::uint64_t kTrials = 10;
constexpr double kLargestRareError = 0.2;  // largest relative standard error with splitting

// Sums over the stays of one stream, or of one replication of the splitting, below the barrier. A
// stay lasts from a downcrossing to the next upcrossing; l is the length of a stay.
struct BelowBarrierSojournSums {
  double stays = 0, length = 0, square = 0;
  double length_to_upper = 0;         // length of the stays that end at the upper of two barriers
  std::vector<double> excess = {};    // sums of (l - t)^+, one for each time t of the survival
  double long_stays = 0, longer = 0;  // number of stays l > t, and sum of (l - t)^+, t: hazard time
  double below = 0, whole = 0, crossings = 0;  // time below the barrier, whole time, upcrossings

  void add(const BelowBarrierSojournSums& other, double factor) {
    excess.resize(other.excess.size());
    for (std::size_t k = 0; k < excess.size(); ++k) excess[k] += factor * other.excess[k];
    for (double BelowBarrierSojournSums::*sum :
         {&BelowBarrierSojournSums::stays, &BelowBarrierSojournSums::length,
          &BelowBarrierSojournSums::length_to_upper, &BelowBarrierSojournSums::square,
          &BelowBarrierSojournSums::long_stays, &BelowBarrierSojournSums::longer,
          &BelowBarrierSojournSums::below, &BelowBarrierSojournSums::whole,
          &BelowBarrierSojournSums::crossings}) {
      this->*sum += factor * other.*sum;
    }
  }
};

// Returns a function of the sums over all streams or replications, with the standard error of the
// jackknife.
ValueWithError estimate_from_sums(
    const std::vector<BelowBarrierSojournSums>& streams,
    const std::function<double(const BelowBarrierSojournSums&)>& function) {
  BelowBarrierSojournSums all;
  for (const BelowBarrierSojournSums& s : streams) all.add(s, 1);
  const auto n = static_cast<double>(streams.size());
  double mean = 0, square = 0;
  std::vector<double> without_one;
  for (const BelowBarrierSojournSums& s : streams) {
    BelowBarrierSojournSums others = all;
    others.add(s, -1);
    without_one.push_back(function(others));
    mean += without_one.back() / n;
  }
  for (const double value : without_one) square += std::pow(value - mean, 2);
  return {function(all), std::sqrt(square * (n - 1) / n)};
}

double hazard(const BelowBarrierSojournSums& s) { return s.long_stays / s.longer; }

// Returns the largest number of samples of a stream in a round, since all samples, impulses and
// kicks of a round are stored.
double most_samples_per_round(const SimulationPlan& plan) {
  return kMostRecords / (1 + plan.expected_event_rate * plan.sampling_interval);
}

// Returns the longest interval h between noise kicks for an energy level. The change of the energy
// by a kick, at most sqrt(2 H) sqrt(2 D h) standard deviations below the level H above the minimum
// of the potential, must be a fraction of H.
double longest_kick_interval_below(const problem::Problem& problem, const SimulationPlan& plan,
                                   double energy) {
  constexpr double kFraction = 0.25;
  const problem::EffectivePotential potential(problem.system);
  double lowest = std::min(potential(potential.y_low()), potential(potential.y_high()));
  for (const double y : potential.extremum_positions()) lowest = std::min(lowest, potential(y));
  const double height = transform::energy_level_in_wall_coordinates(problem, energy) - lowest;
  const double diffusion = plan.kicks.is_acting() ? plan.kicks.diffusion
                                                  : plan.excitation.width * plan.excitation.width /
                                                        (2 * plan.excitation.interval);
  return kFraction * kFraction * height / (4 * diffusion);
}

// Returns the least distance from a displacement barrier to the wall beyond the barrier; empty
// without such a wall.
std::optional<double> distance_to_wall(const problem::Problem& transformed,
                                       const transform::PassageBarrier& barrier) {
  std::optional<double> distance;
  if (barrier.is_energy()) return distance;
  if (const auto& right = transformed.system.right_wall()) {
    distance = right->position - transformed.frame.wall_coordinate(barrier.level);
  }
  if (const auto& left = transformed.system.left_wall(); left && barrier.lower_level) {
    const double below = transformed.frame.wall_coordinate(*barrier.lower_level) - left->position;
    distance = std::min(distance.value_or(below), below);
  }
  return distance;
}

SimulationPlan make_passage_plan(const problem::Problem& problem, const SimulationOptions& options,
                                 const problem::MotionScales& scales,
                                 const transform::PassageBarrier& barrier) {
  SimulationPlan plan = make_simulation_plan(problem, options);
  if (const auto kick_interval = longest_kick_interval(plan);
      kick_interval && barrier.is_energy()) {
    constexpr double kLeastFactor = 1.0 / 64;  // limits the computing time of the burn-in
    const double factor =
        longest_kick_interval_below(problem, plan, barrier.level) / *kick_interval;
    if (factor < 1) scale_kick_intervals(problem, std::max(factor, kLeastFactor), plan);
  }
  const double period = 2 * std::numbers::pi / scales.frequency;
  plan.sampling_interval = period / kSamplesPerPeriod;
  // Histograms, which no passage needs, take a third of the computing time with many bins.
  plan.y_bins = BinFinder({scales.y_low, scales.y_high});
  plan.v_bins = BinFinder({-scales.v_high, scales.v_high});
  // An excursion beyond a barrier that hits the wall may be shorter than the sampling interval, and
  // has a kink, which the parabola of LevelCrossingDetector does not follow.
  constexpr double kSamplesToWall = 8;
  if (const auto distance = distance_to_wall(problem, barrier)) {
    const double time_to_wall = *distance / scales.velocity_deviation;
    plan.sampling_interval = std::min(plan.sampling_interval, time_to_wall / kSamplesToWall);
  }
  const double most_samples = kMostPeriods * kSamplesPerPeriod;
  const double time = options.time.value_or(std::min(
      most_samples * plan.sampling_interval, kMostPassageEvents / plan.expected_event_rate));
  const double samples = time / plan.streams / plan.sampling_interval;
  plan.samples_per_round = static_cast<std::uint64_t>(
      std::ceil(std::min(samples / kRounds, most_samples_per_round(plan))));
  plan.rounds =
      static_cast<std::uint64_t>(std::ceil(samples / static_cast<double>(plan.samples_per_round)));
  return plan;
}

// Measures the stays of one stream below the barrier.
class BelowBarrierSojournCounter {
 public:
  BelowBarrierSojournCounter(const PassageLevel& level, const SimulationPlan& plan,
                             double hazard_time)
      : crossings_(level, plan, false), hazard_time_(hazard_time) {}

  /// Adds a round of a stream.
  void add_round(Simulation& simulation, std::size_t stream) {
    crossings_.add_round(
        simulation, stream, [this](double time) { end_stay(time); },
        [this](double time) { begin_stay(time); });
    if (!closing_) sums_.whole = crossings_.elapsed_time();
  }

  /// Sets the times of the survival probabilities.
  void set_times(const std::vector<double>& times) {
    times_ = times;
    sums_.excess.resize(times.size());
    for (const double stay : stays_) add_excess(stay);
    stays_.clear();
  }

  /// Ends the counting of new stays. Further samples only complete a stay that has begun: the stays
  /// that are open at the end are longer on average, and the estimates would be biased without
  /// them.
  void stop_counting() {
    closing_ = true;
    if (!crossings_.is_above()) sums_.below += sums_.whole - entered_;
    if (const auto time_below = crossings_.time_below_energy()) sums_.below = *time_below;
  }
  bool has_open_stay() const { return begin_.has_value(); }

  const BelowBarrierSojournSums& sums() const { return sums_; }

 private:
  void end_stay(double time) {
    if (!closing_) {
      ++sums_.crossings;
      sums_.below += time - entered_;
      entered_ = time;
    }
    if (!begin_) return;
    const double stay = time - *begin_;
    begin_.reset();
    ++sums_.stays;
    sums_.length += stay;
    sums_.square += stay * stay;
    if (crossings_.last_passage_is_upper()) sums_.length_to_upper += stay;
    times_ ? add_excess(stay) : stays_.push_back(stay);
    if (stay > hazard_time_) {
      ++sums_.long_stays;
      sums_.longer += stay - hazard_time_;
    }
  }

  void begin_stay(double time) {
    if (closing_) return;
    begin_ = time;
    entered_ = time;
  }

  void add_excess(double stay) {
    for (std::size_t k = 0; k < times_->size(); ++k) {
      sums_.excess[k] += std::max(0.0, stay - (*times_)[k]);
    }
  }

  TrajectoryBarrierCrossings crossings_;
  double hazard_time_;
  std::optional<std::vector<double>> times_ = {};
  std::vector<double> stays_ = {};  // lengths of the stays before the call of set_times()
  BelowBarrierSojournSums sums_;
  std::optional<double> begin_ = {};  // begin of the present stay; empty before the first stay
  double entered_ = 0;                // time of the last crossing
  bool closing_ = false;
};

double stay_count(const std::vector<BelowBarrierSojournSums>& streams) {
  double stays = 0;
  for (const BelowBarrierSojournSums& s : streams) stays += s.stays;
  return stays;
}

// Simulation of the stays below a barrier in the stationary process.
class StaySimulation {
 public:
  StaySimulation(const problem::Problem& problem, const SimulationPlan& plan,
                 const PassageLevel& level, double hazard_time, const SimulationOptions& options,
                 double goal)
      : simulation_(problem, plan),
        options_(&options),
        goal_(goal),
        counters_(static_cast<std::size_t>(plan.streams), {level, plan, hazard_time}) {
    std::holds_alternative<EnergyLevelForPassage>(level)
        ? simulation_.enable_state_recording()
        : simulation_.enable_displacement_recording();
    simulation_.run_burn_in();
  }

  /// Simulates up to the given number of rounds, until the relative standard error is at most the
  /// goal.
  void simulate_rounds(std::uint64_t rounds) {
    while (simulation_.sampling_round_count() < rounds && !has_reached_goal()) {
      run_round();
      if (options_->progress) {
        options_->progress({static_cast<double>(simulation_.sampling_round_count()) /
                            static_cast<double>(simulation_.plan_of_simulation().rounds) / 2});
      }
    }
  }

  void set_times(const std::vector<double>& times) {
    for (BelowBarrierSojournCounter& counter : counters_) counter.set_times(times);
  }

  /// Completes the stays that have begun.
  /// @return whether all stays are complete, in twice the simulated time
  bool complete_stays() {
    for (BelowBarrierSojournCounter& counter : counters_) counter.stop_counting();
    const auto has_open_stay = [&] {
      return std::ranges::any_of(counters_, &BelowBarrierSojournCounter::has_open_stay);
    };
    const std::uint64_t most_rounds =
        simulation_.sampling_round_count() + simulation_.plan_of_simulation().rounds;
    while (simulation_.sampling_round_count() < most_rounds && has_open_stay()) run_round();
    return !has_open_stay();
  }

  std::vector<BelowBarrierSojournSums> sums() const {
    std::vector<BelowBarrierSojournSums> sums;
    for (const BelowBarrierSojournCounter& counter : counters_) sums.push_back(counter.sums());
    return sums;
  }

  /// Returns the mean time from the stationary law to the passage, from the complete stays.
  ValueWithError mean_time() const {
    return estimate_from_sums(
        sums(), [](const BelowBarrierSojournSums& s) { return s.square / 2 / s.length; });
  }

  bool has_reached_goal() const {
    if (options_->time || stay_count(sums()) < kFewestStaysAtGoal) return false;
    const ValueWithError mean = mean_time();
    return mean.error <= goal_ * mean.value;
  }

  /// Returns the expected relative standard error of the mean time after all rounds of the plan;
  /// infinite with too few stays.
  double expected_relative_error() const {
    if (stay_count(sums()) < kFewestStays) return std::numeric_limits<double>::infinity();
    const ValueWithError mean = mean_time();
    return mean.error / mean.value *
           std::sqrt(static_cast<double>(simulation_.sampling_round_count()) /
                     static_cast<double>(simulation_.plan_of_simulation().rounds));
  }

 private:
  void run_round() {
    simulation_.simulate_and_sample_one_round();
    base::parallel_for(counters_.size(), simulation_.plan_of_simulation().threads,
                       [&](std::size_t s) { counters_[s].add_round(simulation_, s); });
  }

  Simulation simulation_;
  const SimulationOptions* options_;
  double goal_;
  std::vector<BelowBarrierSojournCounter> counters_;
};

// Returns the number of passages that count as independent: the time below the barrier in units of
// the mean passage time, since passages come in clumps.
double independent_passage_count(const std::vector<BelowBarrierSojournSums>& streams) {
  double length = 0, square = 0;
  for (const BelowBarrierSojournSums& s : streams) {
    length += s.length;
    square += s.square;
  }
  return length * length / (square / 2);
}

// Returns the standard error of a probability below two hits among `passages` independent passages:
// the standard error for no hit. The differences between the streams show only hits.
double least_error_of_probability(double probability, double passages) {
  constexpr double kFewHits = 2;
  return probability * passages < kFewHits ? probability_estimate(passages, 0, 0).error : 0;
}

// Stays below the barrier in the stationary process.
struct StationaryStays {
  // of each stream or replication; empty for too few stays
  std::vector<BelowBarrierSojournSums> sums = {};
  std::vector<double> times = {};  // times of the survival probabilities
  /// Time after which the hazard is treated as constant in place of a simulation; infinite without
  /// splitting
  double horizon = std::numeric_limits<double>::infinity();
  std::string details = {};
  /// Reason why `sums` is empty, or why its errors are large; otherwise empty
  std::string reason = {};
};

// Returns the sums over the stays of the splitting, per unit time of the stationary process.
std::vector<BelowBarrierSojournSums> sums_of_replications(
    const std::vector<RarePassages>& replications, double horizon,
    const std::vector<double>& times) {
  std::vector<BelowBarrierSojournSums> sums;
  for (const RarePassages& r : replications) {
    BelowBarrierSojournSums s{.length = 1 - r.weight * r.time_above, .whole = 1};
    s.crossings = r.weight * static_cast<double>(r.crossings);
    s.below = 1 - r.weight * r.time_above_given_barrier;
    s.square = 2 * horizon * s.length;
    s.longer = s.length;
    s.excess.assign(times.size(), s.length);
    for (const double stay : r.stays) {
      s.square -= r.weight * stay * (2 * horizon - stay);
      s.longer -= r.weight * stay;
      s.long_stays += stay >= horizon ? r.weight : 0;
      for (std::size_t k = 0; k < times.size(); ++k) {
        s.excess[k] -= r.weight * std::min(stay, times[k]);
      }
    }
    sums.push_back(std::move(s));
  }
  return sums;
}

// Estimates the stays by splitting, with the times of the survival probabilities unless `times`
// gives these times.
// @param largest_error largest relative standard error of the hazard for a result
std::optional<StationaryStays> estimate_rare_stays(const problem::Problem& problem,
                                                   const SimulationPlan& plan,
                                                   const PassageLevel& level,
                                                   const problem::MotionScales& scales,
                                                   const std::vector<double>& times, double goal,
                                                   double largest_error) {
  const double horizon = kDecayTimesOfRareStays / scales.slowest_decay_rate;
  const auto estimate_hazard = [&](const std::vector<RarePassages>& replications) {
    return estimate_from_sums(sums_of_replications(replications, horizon, {}), hazard);
  };
  const double time =
      static_cast<double>(plan.rounds) * plan.simulated_time_per_round() * plan.streams;
  const RarePassageRun run =
      simulate_rare_passages(problem, plan, level, scales, horizon, time, [&](const auto& so_far) {
        const ValueWithError g = estimate_hazard(so_far);
        return g.error <= goal * g.value;
      });
  if (run.replications.empty()) return std::nullopt;
  const ValueWithError g = estimate_hazard(run.replications);
  if (!(g.error <= largest_error * g.value)) return std::nullopt;
  StationaryStays stays{.times = times, .horizon = horizon};
  if (times.empty()) stays.times = transform::automatic_survival_times(1 / g.value);
  stays.sums = sums_of_replications(run.replications, horizon, stays.times);
  if (g.error > kLargestRareError * g.value) {
    stays.reason = fmt::format(
        "rare passages: the relative standard error of the hazard is {:.2g}; increase --time",
        g.error / g.value);
  }
  stays.details = fmt::format("{} replications of the splitting with {} levels",
                              run.replications.size(), run.levels);
  return stays;
}

// Estimates the stays by one long simulation, or by splitting if the long simulation contains too
// few passages.
StationaryStays estimate_stays(const problem::Problem& problem, const SimulationPlan& plan,
                               const PassageLevel& level, const problem::MotionScales& scales,
                               const std::vector<double>& times, const SimulationOptions& options,
                               double goal) {
  const std::uint64_t trial = options.time ? plan.rounds : (plan.rounds + kTrials - 1) / kTrials;
  StaySimulation simulation(problem, plan, level, kDecayTimes / scales.slowest_decay_rate, options,
                            goal);
  simulation.simulate_rounds(trial);
  const double expected_error = simulation.expected_relative_error();
  const bool has_too_few = stay_count(simulation.sums()) < kFewestStays;
  // The levels of the splitting lead to the end with the lower energy of two barriers alone.
  const auto* barriers = std::get_if<DisplacementBarriers>(&level);
  const bool can_split = barriers == nullptr || !barriers->are_two;
  if (can_split &&
      (options.time ? has_too_few : !simulation.has_reached_goal() && expected_error > goal)) {
    const auto rare =
        estimate_rare_stays(problem, plan, level, scales, times, goal, expected_error);
    if (rare) return *rare;
  }
  simulation.simulate_rounds(plan.rounds);
  StationaryStays stays{.times = times};
  const double count = stay_count(simulation.sums());
  if (count < kFewestStays) {
    stays.reason = fmt::format("only {} passages in the simulated time; increase --time", count);
    return stays;
  }
  if (!times.empty()) simulation.set_times(times);
  if (!simulation.complete_stays()) {
    stays.reason = "a stay below the barrier lasted longer than the simulation; increase --time";
    return stays;
  }
  if (times.empty()) {
    stays.times = transform::automatic_survival_times(simulation.mean_time().value);
    simulation.set_times(stays.times);
  }
  stays.sums = simulation.sums();
  stays.details = fmt::format("{:.0f} stays below the barrier", stay_count(stays.sums));
  return stays;
}

// Simulates passages from a state in wall coordinates, to which each stream returns in the round
// after a passage, or after the time StationaryStays::horizon without a passage. Every stream makes
// the same number of passages, since a limit of the simulated time would favour short passages.
// Sets the values of `result` for the start from a point; the mean time is absent if the passages
// take too long.
// @param mean approximate mean time of a simulated passage
void simulate_passages_from_point(Simulation& simulation, const PassageLevel& level,
                                  const transform::PassageStartState& start, double mean,
                                  double most_time, const StationaryStays& stationary,
                                  const SimulationOptions& options,
                                  transform::FirstPassageResult& result) {
  constexpr double kMostPassages = 5e3, kFewestPerStream = 4;
  const SimulationPlan& plan = simulation.plan_of_simulation();
  const auto streams = static_cast<std::size_t>(plan.streams);
  const double per_stream =
      std::floor(std::min(kMostPassages, most_time / mean) / static_cast<double>(streams));
  if (per_stream < kFewestPerStream) return;
  const auto passages = static_cast<std::size_t>(per_stream);
  struct Passage {
    double time;
    bool is_upper;  // whether the passage is that of the upper of two barriers
  };
  std::vector<std::vector<Passage>> found(streams);
  const TrajectoryBarrierCrossings at_start(level, plan, true);
  std::vector<TrajectoryBarrierCrossings> crossings(streams, at_start);
  for (std::size_t s = 0; s < streams; ++s)
    simulation.restart_trajectory_stream(s, start.y, start.ydot);
  // The mean passage time from a point may be far longer than from the stationary law.
  constexpr double kMostRepetitions = 4;
  const double most_rounds =
      kMostRepetitions * most_time / static_cast<double>(streams) / plan.simulated_time_per_round();
  double rounds = 0;
  // The first sample is half an interval after the start.
  const double offset =
      std::holds_alternative<DisplacementBarriers>(level) ? plan.sampling_interval / 2 : 0;
  for (std::size_t finished = 0; finished < streams;) {
    if (++rounds > most_rounds) return;
    simulation.simulate_and_sample_one_round();
    finished = 0;
    for (std::size_t s = 0; s < streams; ++s) {
      std::optional<Passage> passage;
      crossings[s].add_round(
          simulation, s,
          [&](double time) {
            if (!passage) passage = {time + offset, crossings[s].last_passage_is_upper()};
          },
          [](double) {});
      if (!passage && crossings[s].elapsed_time() >= stationary.horizon)
        passage = {stationary.horizon, true};
      if (passage) {
        if (found[s].size() < passages) {
          found[s].push_back({std::min(passage->time, stationary.horizon), passage->is_upper});
        }
        crossings[s] = at_start;
        simulation.restart_trajectory_stream(s, start.y, start.ydot);
      }
      finished += found[s].size() >= passages ? 1 : 0;
    }
    if (options.progress) {
      options.progress({0.5 + 0.5 * static_cast<double>(finished) / static_cast<double>(streams)});
    }
  }
  const ValueWithError g = std::isfinite(stationary.horizon)
                               ? estimate_from_sums(stationary.sums, hazard)
                               : ValueWithError{};
  const auto is_open = [&](double time) { return time >= stationary.horizon; };
  const double n = static_cast<double>(streams) * per_stream;
  const auto mean_estimate = [](double count, double sum, double square) -> ValueWithError {
    const double value = sum / count;
    return {value, std::sqrt(std::max(0.0, square / count - value * value) / (count - 1))};
  };
  // Returns the mean of f(passage time, hazard g) over all passages, by a function of their number,
  // sum and sum of squares. The standard error contains the error of the hazard after the horizon.
  const auto mean_of = [&](const auto& estimate,
                           const std::function<double(double, double)>& f) -> ValueWithError {
    double sum = 0, square = 0, changed = 0;
    for (const auto& of_stream : found) {
      for (const Passage& passage : of_stream) {
        sum += f(passage.time, g.value);
        square += std::pow(f(passage.time, g.value), 2);
        changed += f(passage.time, g.value + g.error);
      }
    }
    ValueWithError estimated = estimate(n, sum, square);
    estimated.error = std::hypot(estimated.error, (changed - sum) / n);
    return estimated;
  };
  for (const double t : stationary.times) {
    const auto survival = [&](double time, double hazard_rate) {
      if (t < stationary.horizon) return time > t ? 1.0 : 0.0;
      return is_open(time) ? std::exp(-hazard_rate * (t - stationary.horizon)) : 0.0;
    };
    result.survival_from_point.push_back(mean_of(probability_estimate, survival));
  }
  result.mean_from_point = mean_of(mean_estimate, [&](double time, double hazard_rate) {
    return time + (is_open(time) ? 1 / hazard_rate : 0.0);
  });
  if (const auto* barriers = std::get_if<DisplacementBarriers>(&level);
      barriers != nullptr && barriers->are_two) {
    double upper = 0;
    for (const auto& of_stream : found) {
      upper += static_cast<double>(std::ranges::count_if(of_stream, &Passage::is_upper));
    }
    result.upper_exit_from_point = probability_estimate(n, upper, upper);
  }
}

// Returns why the simulation does not treat a barrier; empty if it does.
std::string unsupported_barrier_reason(const problem::Problem& transformed,
                                       const transform::PassageBarrier& barrier) {
  if (!barrier.is_energy()) {
    std::string reason = problem::barrier_unsupported_reason(
        transformed, transformed.frame.wall_coordinate(barrier.level));
    if (reason.empty() && barrier.lower_level) {
      reason = problem::barrier_unsupported_reason(
          transformed, transformed.frame.wall_coordinate(*barrier.lower_level));
    }
    return reason;
  }
  return transformed.noise_factor
             ? "an energy barrier does not support noise.factor; use --displacement"
             : "";
}

DisplacementBarriers displacement_barriers(const problem::WallFrame& frame,
                                           const transform::PassageBarrier& barrier) {
  const double upper = frame.wall_coordinate(barrier.level);
  if (!barrier.lower_level) return {.half_width = upper};
  const double lower = frame.wall_coordinate(*barrier.lower_level);
  return {.half_width = (upper - lower) / 2, .centre = (upper + lower) / 2, .are_two = true};
}

EnergyLevelForPassage energy_passage_level(const problem::Problem& transformed,
                                           const SimulationPlan& plan,
                                           const problem::MotionScales& scales, double energy) {
  const bool even = plan.excitation.arrivals == ImpulseProcess::Arrivals::even;
  return {.potential = {problem::EffectivePotential(transformed.system), scales},
          .level = transform::energy_level_in_wall_coordinates(transformed, energy),
          .impulse_variance = even ? plan.excitation.width * plan.excitation.width : 0,
          .has_noise = even || plan.kicks.is_acting()};
}

bool is_below(const transform::PassageStartState& state, const EnergyLevelForPassage& energy) {
  return state.ydot * state.ydot / 2 + energy.potential(state.y) < energy.level;
}

// Estimates the passage with the interval between noise kicks of a plan.
// @param goal relative standard error of the mean passage time at which the simulation ends
transform::FirstPassageResult estimate_passage_with_plan(
    const problem::Problem& transformed, const SimulationPlan& plan,
    const problem::MotionScales& scales, const SimulationOptions& options,
    const transform::PassageBarrier& barrier, const std::vector<double>& times,
    std::optional<transform::PassageStartState> start, double goal) {
  transform::FirstPassageResult passage{.id = solution_id(options)};
  passage.has_standard_errors = true;
  const bool is_energy = barrier.is_energy();
  const double displacement = transformed.frame.wall_coordinate(barrier.level);
  const PassageLevel level = is_energy
                                 ? energy_passage_level(transformed, plan, scales, barrier.level)
                                 : PassageLevel(displacement_barriers(transformed.frame, barrier));
  const StationaryStays stays =
      estimate_stays(transformed, plan, level, scales, times, options, goal);
  if (stays.sums.empty()) {
    passage.reason = stays.reason;
    passage.status = Status::not_converged;
    return passage;
  }
  const std::vector<BelowBarrierSojournSums>& sums = stays.sums;
  const double horizon = stays.horizon;
  const bool is_rare = std::isfinite(horizon);
  // Under noise the barrier of the stays is shifted. The mean time from a state between the shifted
  // and the given barrier is 0, so that the means refer to the time below the given barrier.
  const bool is_shifted = is_energy && std::get<EnergyLevelForPassage>(level).has_noise;
  const auto length = [is_shifted](const BelowBarrierSojournSums& s) {
    return is_shifted ? s.below : s.length;
  };
  passage.mean_from_stationary = estimate_from_sums(sums, [&](const BelowBarrierSojournSums& s) {
    return (s.square / 2 + (is_rare ? s.longer / hazard(s) : 0)) / length(s);
  });
  double long_stays = 0;
  for (const BelowBarrierSojournSums& s : sums) long_stays += s.long_stays;
  if (is_rare || long_stays >= kFewestStays) passage.hazard = estimate_from_sums(sums, hazard);
  if (!is_energy) {
    passage.rice_rate = estimate_from_sums(
        sums, [](const BelowBarrierSojournSums& s) { return s.crossings / s.whole; });
  }
  passage.probability_below =
      estimate_from_sums(sums, [](const BelowBarrierSojournSums& s) { return s.below / s.whole; });
  // With splitting the survival probabilities follow from the hazard.
  const auto least_error = [&, passages = independent_passage_count(sums)](double probability) {
    return is_rare ? 0 : least_error_of_probability(probability, passages);
  };
  if (barrier.lower_level) {
    const ValueWithError upper = estimate_from_sums(
        sums, [&](const BelowBarrierSojournSums& s) { return s.length_to_upper / length(s); });
    const double error =
        std::max({upper.error, least_error(upper.value), least_error(1 - upper.value)});
    passage.upper_exit_from_stationary = {upper.value, error};
  }
  passage.times = stays.times;
  for (std::size_t k = 0; k < passage.times.size(); ++k) {
    const double time = passage.times[k];
    ValueWithError survival = estimate_from_sums(sums, [&](const BelowBarrierSojournSums& s) {
      return (time > horizon ? s.longer * std::exp(-hazard(s) * (time - horizon)) : s.excess[k]) /
             length(s);
    });
    survival.error = std::max(survival.error, least_error(survival.value));
    passage.survival_from_stationary.push_back(survival);
  }

  std::optional<double> lower;
  if (barrier.lower_level) lower = transformed.frame.wall_coordinate(*barrier.lower_level);
  start = transform::passage_start_state(
      transformed, is_energy ? std::numeric_limits<double>::infinity() : displacement, start,
      lower);
  if (start && is_energy && !is_below(*start, std::get<EnergyLevelForPassage>(level)))
    start.reset();
  if (start) {
    SimulationPlan from_point = plan;
    const double mean = std::min(passage.mean_from_stationary->value, horizon);
    from_point.samples_per_round = static_cast<std::uint64_t>(
        std::ceil(std::min(mean / 10 / plan.sampling_interval, most_samples_per_round(plan))));
    Simulation restarted(transformed, from_point);
    is_energy ? restarted.enable_state_recording() : restarted.enable_displacement_recording();
    const double time =
        is_rare ? static_cast<double>(plan.rounds) * plan.simulated_time_per_round() * plan.streams
                : sums.front().whole * plan.streams;
    simulate_passages_from_point(restarted, level, *start, mean, time, stays, options, passage);
  }
  passage.details = stays.details;
  passage.reason = short_burn_in_reason(plan, options);
  passage.status = passage.reason.empty() ? Status::ok : Status::not_converged;
  if (passage.status == Status::ok && !stays.reason.empty()) {
    passage.status = Status::inaccurate;
    passage.reason = stays.reason;
  }
  return passage;
}

// Adds the errors by the interval between noise kicks to the standard errors.
// @param doubled result with twice the interval
void add_kick_interval_errors_of_passage(const transform::FirstPassageResult& doubled,
                                         transform::FirstPassageResult& passage) {
  passage.has_kick_interval_errors = true;
  // A barrier is passed between kicks too, which leaves an error of first order.
  constexpr int kOrder = 1;
  const auto error_of = [](const ValueWithError& at, const ValueWithError& at_doubled) {
    return kick_interval_error(at_doubled.value - at.value, std::hypot(at.error, at_doubled.error),
                               kOrder);
  };
  const ValueWithError mean = *passage.mean_from_stationary,
                       mean_of_doubled = *doubled.mean_from_stationary;
  using Result = transform::FirstPassageResult;
  for (std::optional<ValueWithError> Result::*quantity :
       {&Result::hazard, &Result::mean_from_point, &Result::mean_from_stationary,
        &Result::rice_rate, &Result::probability_below, &Result::upper_exit_from_point,
        &Result::upper_exit_from_stationary}) {
    std::optional<ValueWithError>& value = passage.*quantity;
    if (!value) continue;
    const std::optional<ValueWithError>& other = doubled.*quantity;
    other ? void(value->error += error_of(*value, *other)) : value.reset();
  }
  for (std::vector<ValueWithError> Result::*survival :
       {&Result::survival_from_point, &Result::survival_from_stationary}) {
    std::vector<ValueWithError>& values = passage.*survival;
    const std::vector<ValueWithError>& others = doubled.*survival;
    if (values.size() != others.size()) values.clear();
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k].error += error_of(values[k], others[k]);
  }
  // Largest difference of the mean times for status ok, relative and in standard errors
  constexpr double kLargestDifference = 0.05, kLargestInStandardErrors = 2;
  const double difference = std::abs(mean_of_doubled.value - mean.value);
  if (passage.status == Status::ok && difference > kLargestDifference * mean.value &&
      difference > kLargestInStandardErrors * std::hypot(mean.error, mean_of_doubled.error)) {
    passage.status = Status::inaccurate;
    passage.reason = fmt::format(
        "twice the interval between noise kicks changes the mean time by {:.2g} %; use fd",
        100 * difference / mean.value);
  }
  const ValueWithError& total = *passage.mean_from_stationary;
  if (passage.status == Status::ok && total.error > kLargestRareError * total.value) {
    passage.status = Status::inaccurate;
    passage.reason = fmt::format(
        "the relative error of the mean time, with the error by the interval between noise kicks, is "
        "{:.2g}; increase --time",
        total.error / total.value);
  }
}

}  // namespace

transform::FirstPassageResult estimate_passage(const problem::Problem& problem,
                                               const SimulationOptions& options,
                                               const transform::PassageBarrier& barrier,
                                               const std::vector<double>& times,
                                               std::optional<transform::PassageStartState> start) {
  const base::Stopwatch stopwatch;
  transform::FirstPassageResult passage{.id = solution_id(options)};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  passage.reason = unsupported_functional_reason(transformed, options);
  if (passage.reason.empty()) passage.reason = unsupported_barrier_reason(transformed, barrier);
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  const problem::MotionScales scales = problem::motion_scales(transformed);
  const SimulationPlan plan = make_passage_plan(transformed, options, scales, barrier);
  passage =
      estimate_passage_with_plan(transformed, plan, scales, options, barrier, times, start, kGoal);
  auto doubled = plan_with_doubled_kick_interval(transformed, plan);
  if (doubled && passage.mean_from_stationary) {
    doubled->rounds = (plan.rounds + 1) / 2;
    const auto with_doubled_interval =
        estimate_passage_with_plan(transformed, *doubled, scales, options, barrier, passage.times,
                                   start, std::numbers::sqrt2 * kGoal);
    if (with_doubled_interval.mean_from_stationary) {
      add_kick_interval_errors_of_passage(with_doubled_interval, passage);
    } else {
      passage.status = Status::not_converged;
      passage.reason =
          "too few passages for the error of the interval between noise kicks; increase --time";
    }
  }
  passage.seconds = stopwatch.seconds();
  return passage;
}

}  // namespace fpkcheck::mcs
