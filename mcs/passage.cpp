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
constexpr double kGoal = 0.01, kMostPeriods = 2e6, kMostPassageEvents = 6e7;
// Least number of stays for a result, and least number of stays for an end of the simulation at
// kGoal: stays are correlated, and a standard error computed from few stays may be accidentally
// small.
constexpr double kFewestStays = 100, kFewestStaysAtGoal = 1000;
constexpr double kMostRecords = 1e5;  // largest number of stored records of a stream in a round
constexpr int kRounds = 50;           // number of rounds of the longest simulation
// Time, in decay times of the slowest mode, after which the hazard is treated as constant
constexpr double kDecayTimes = 3;

// Finds the crossings of a level in evenly spaced samples, by linear interpolation between samples.
// A parabola through three samples finds excursions above the level between samples.
class LevelCrossingDetector {
 public:
  /// @param starts_below whether the state before the first sample is below the level
  LevelCrossingDetector(double level, double interval, bool starts_below = false)
      : level_(level), interval_(interval), starts_below_(starts_below) {}

  /// Calls `on_upcrossing` and `on_downcrossing` with the times of the level crossings between the
  /// previous sample and the sample y.
  template <class Up, class Down>
  void add_sample(double y, const Up& on_upcrossing, const Down& on_downcrossing) {
    if (count_ == 0 && y >= level_ && starts_below_) {
      on_upcrossing(0);
    } else if (count_ >= 1 && y >= level_ && last_ < level_) {
      on_upcrossing(crossing_time(y));
    } else if (count_ >= 1 && y < level_ && last_ >= level_) {
      on_downcrossing(crossing_time(y));
    } else if (count_ >= 2 && y < level_ && last_ < level_ && before_ < level_ &&
               last_ >= before_ && last_ >= y) {
      const double slope = (y - before_) / 2, curvature = y - 2 * last_ + before_;
      const double excess = curvature < 0 ? last_ - slope * slope / (2 * curvature) - level_ : -1;
      if (excess > 0) {
        const double top = -slope / curvature, half = std::sqrt(-2 * excess / curvature);
        const double at = static_cast<double>(count_) - 1 + top;
        on_upcrossing((at - half) * interval_);
        on_downcrossing((at + half) * interval_);
      }
    }
    before_ = last_;
    last_ = y;
    ++count_;
  }

  bool is_above() const { return count_ > 0 && last_ >= level_; }
  double elapsed_time() const { return static_cast<double>(count_) * interval_; }

 private:
  double crossing_time(double y) const {
    return (static_cast<double>(count_) - 1 + (level_ - last_) / (y - last_)) * interval_;
  }

  double level_, interval_;
  bool starts_below_;
  double before_ = 0, last_ = 0;
  std::uint64_t count_ = 0;
};

// The potential of the spring: a polynomial, or a table of the potential of a formula. Without the
// table, each value of the potential would take ten evaluations of the formula.
class TabulatedPotential {
 public:
  TabulatedPotential(const problem::Problem& problem, const problem::MotionScales& scales)
      : potential_(problem.system), low_(scales.y_low) {
    if (potential_.polynomial_or_null() != nullptr) return;
    step_ = (scales.y_high - scales.y_low) / kIntervals;
    for (int n = 0; n <= kIntervals; ++n) {
      const double y = low_ + n * step_;
      values_.push_back(potential_(y));
      slopes_.push_back(potential_.potential_slope(y));
    }
  }

  double operator()(double y) const {
    if (potential_.polynomial_or_null() != nullptr) return (*potential_.polynomial_or_null())(y);
    const double node = (y - low_) / step_;
    if (!(node >= 0 && node < kIntervals)) return potential_(y);
    const auto n = static_cast<std::size_t>(node);
    // Cubic Hermite interpolation
    const double t = node - static_cast<double>(n), u = 1 - t;
    return u * u * (1 + 2 * t) * values_[n] + t * t * (1 + 2 * u) * values_[n + 1] +
           t * u * step_ * (u * slopes_[n] - t * slopes_[n + 1]);
  }

 private:
  static constexpr int kIntervals = 4096;

  problem::EffectivePotential potential_;
  double low_, step_ = 0;
  std::vector<double> values_, slopes_;
};

// An energy level in wall coordinates.
struct EnergyLevelForPassage {
  TabulatedPotential potential;
  double level;
  /// Variance of the velocity change by an impulse, if evenly spaced impulses replace white noise
  double impulse_variance;
  bool has_noise;  ///< whether noise kicks or evenly spaced impulses change the energy
};

// Finds the crossings of an energy level in the recorded states of a stream.
class EnergyCrossingDetector {
 public:
  /// @param energy must outlive this object
  /// @param starts_below whether the state before the first recorded state is below the level
  EnergyCrossingDetector(const EnergyLevelForPassage& energy, double simulated_time_per_round,
                         double sampling_interval, bool starts_below = false)
      : energy_(&energy),
        round_time_(simulated_time_per_round),
        sampling_interval_(sampling_interval) {
    if (starts_below) last_ = -1;
  }

  template <class Up, class Down>
  void add_round(const std::vector<RecordedState>& states, const Up& on_upcrossing,
                 const Down& on_downcrossing) {
    elapsed_ += round_time_;
    for (const RecordedState& state : states) {
      const double excess = energy(state) - energy_->level;
      if (state.event == RecordedState::Event::sample) {
        time_below_ += excess < 0 ? sampling_interval_ : 0;
        // Under noise only the states after kicks count, with the shifted barrier.
        if (energy_->has_noise) continue;
      }
      add_excess(excess + barrier_shift(state), elapsed_ - state.time_to_end, on_upcrossing,
                 on_downcrossing);
    }
  }

  bool is_above() const { return last_ && *last_ >= 0; }
  double elapsed_time() const { return elapsed_; }
  double time_below() const { return time_below_; }

 private:
  double energy(const RecordedState& state) const {
    return state.v * state.v / 2 + energy_->potential(state.y);
  }

  // Returns the distance by which the barrier is lower for a state after a noise kick.
  double barrier_shift(const RecordedState& state) const {
    constexpr double kShift = 0.5826;  // -zeta(1/2) / sqrt(2 pi)
    const double variance = state.event == RecordedState::Event::after_impulse
                                ? energy_->impulse_variance
                                : state.kick_variance;
    return kShift * std::abs(state.v) * std::sqrt(variance);
  }

  template <class Up, class Down>
  void add_excess(double excess, double time, const Up& on_upcrossing,
                  const Down& on_downcrossing) {
    if (last_ && (excess >= 0) != (*last_ >= 0)) {
      const double at = std::lerp(time, last_time_, excess / (excess - *last_));
      excess >= 0 ? on_upcrossing(energy_->has_noise ? time : at) : on_downcrossing(at);
    }
    last_ = excess;
    last_time_ = time;
  }

  const EnergyLevelForPassage* energy_;
  double round_time_, sampling_interval_;
  double elapsed_ = 0, time_below_ = 0;
  std::optional<double> last_ = {};  // excess of the last state; empty before the first state
  double last_time_ = 0;
};

// Barriers of the displacement in wall coordinates: y = centre + half_width and, with two barriers,
// y = centre - half_width. With one barrier the centre is 0.
struct DisplacementBarriers {
  double half_width;
  double centre = 0;
  bool are_two = false;

  // Returns the function of y whose upcrossings of `half_width` are the passages.
  double distance(double y) const { return are_two ? std::abs(y - centre) : y; }
};

DisplacementBarriers displacement_barriers(const problem::WallFrame& frame,
                                           const transform::PassageBarrier& barrier) {
  const double upper = frame.wall_coordinate(barrier.level);
  if (!barrier.lower_level) return {.half_width = upper};
  const double lower = frame.wall_coordinate(*barrier.lower_level);
  return {.half_width = (upper - lower) / 2, .centre = (upper + lower) / 2, .are_two = true};
}

// A barrier in wall coordinates: displacements or an energy level.
using PassageLevel = std::variant<DisplacementBarriers, EnergyLevelForPassage>;

// Finds the crossings of a barrier in the rounds of one stream.
class TrajectoryBarrierCrossings {
 public:
  /// @param starts_below whether the stream starts below the barrier
  TrajectoryBarrierCrossings(const PassageLevel& level, const SimulationPlan& plan,
                             bool starts_below)
      : detector_(make_detector(level, plan, starts_below)) {
    if (const auto* barriers = std::get_if<DisplacementBarriers>(&level)) barriers_ = *barriers;
  }

  /// Calls `on_upcrossing` and `on_downcrossing` with the times of the crossings in a round, and
  /// removes the records of the round.
  template <class Up, class Down>
  void add_round(Simulation& simulation, std::size_t stream, const Up& on_upcrossing,
                 const Down& on_downcrossing) {
    std::vector<double>& series = simulation.displacement_series(stream);
    std::vector<RecordedState>& states = simulation.recorded_states(stream);
    if (auto* displacement = std::get_if<LevelCrossingDetector>(&detector_)) {
      for (const double y : series) {
        displacement->add_sample(
            barriers_.distance(y),
            [&](double time) {
              last_passage_is_upper_ = y > barriers_.centre;
              on_upcrossing(time);
            },
            on_downcrossing);
      }
    } else {
      std::get<EnergyCrossingDetector>(detector_).add_round(states, on_upcrossing, on_downcrossing);
    }
    series.clear();
    states.clear();
  }

  bool is_above() const {
    return std::visit([](const auto& detector) { return detector.is_above(); }, detector_);
  }
  double elapsed_time() const {
    return std::visit([](const auto& detector) { return detector.elapsed_time(); }, detector_);
  }
  /// Returns whether the last upcrossing was a passage of the upper displacement barrier.
  bool last_passage_is_upper() const { return last_passage_is_upper_; }
  /// Returns the time below an energy level; empty for a displacement.
  std::optional<double> time_below_energy() const {
    const auto* energy = std::get_if<EnergyCrossingDetector>(&detector_);
    return energy != nullptr ? std::optional(energy->time_below()) : std::nullopt;
  }

 private:
  using Detector = std::variant<LevelCrossingDetector, EnergyCrossingDetector>;
  static Detector make_detector(const PassageLevel& level, const SimulationPlan& plan,
                                bool starts_below) {
    if (const auto* energy = std::get_if<EnergyLevelForPassage>(&level)) {
      return EnergyCrossingDetector(*energy, plan.simulated_time_per_round(),
                                    plan.sampling_interval, starts_below);
    }
    return LevelCrossingDetector(std::get<DisplacementBarriers>(level).half_width,
                                 plan.sampling_interval, starts_below);
  }

  Detector detector_;
  DisplacementBarriers barriers_ = {};
  bool last_passage_is_upper_ = false;
};

// Sums over the stays of one stream below the barrier. A stay lasts from a downcrossing to the next
// upcrossing; l is the length of a stay.
struct BelowBarrierSojournSums {
  double stays = 0, length = 0, square = 0;
  double length_to_upper = 0;         // length of the stays that end at the upper of two barriers
  std::vector<double> excess;         // sums of (l - t)^+, one for each time t of the survival
  double long_stays = 0, longer = 0;  // number of stays l > t, and sum of (l - t)^+, t: hazard time
  double below = 0, whole = 0, crossings = 0;  // time below the barrier, whole time, upcrossings
};

// Returns the ratio of two sums over all streams, with the standard error of the linearised ratio.
ValueWithError ratio_of_sums(
    const std::vector<BelowBarrierSojournSums>& streams,
    const std::function<double(const BelowBarrierSojournSums&)>& numerator,
    const std::function<double(const BelowBarrierSojournSums&)>& denominator) {
  double top = 0, bottom = 0, square = 0;
  for (const BelowBarrierSojournSums& s : streams) {
    top += numerator(s);
    bottom += denominator(s);
  }
  const double value = top / bottom;
  for (const BelowBarrierSojournSums& s : streams)
    square += std::pow(numerator(s) - value * denominator(s), 2);
  const auto n = static_cast<double>(streams.size());
  return {value, std::sqrt(square * n / (n - 1)) / std::abs(bottom)};
}

ValueWithError mean_time_from_stationary(const std::vector<BelowBarrierSojournSums>& streams) {
  return ratio_of_sums(
      streams, [](const BelowBarrierSojournSums& s) { return s.square / 2; },
      [](const BelowBarrierSojournSums& s) { return s.length; });
}

// Returns the largest number of samples of a stream in a round, since all samples, impulses and
// kicks of a round are stored.
double most_samples_per_round(const SimulationPlan& plan) {
  return kMostRecords / (1 + plan.expected_event_rate * plan.sampling_interval);
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

// @param distance_to_wall distance from a barrier to the wall beyond the barrier; may be empty
SimulationPlan make_passage_plan(const problem::Problem& problem, const SimulationOptions& options,
                                 const problem::MotionScales& scales,
                                 const std::optional<double>& distance_to_wall) {
  SimulationPlan plan = make_simulation_plan(problem, options);
  const double period = 2 * std::numbers::pi / scales.frequency;
  plan.sampling_interval = period / kSamplesPerPeriod;
  // An excursion beyond a barrier that hits the wall may be shorter than the sampling interval, and
  // has a kink, which the parabola of LevelCrossingDetector does not follow.
  constexpr double kSamplesToWall = 8;
  if (distance_to_wall) {
    const double time_to_wall = *distance_to_wall / scales.velocity_deviation;
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
                             double hazard_time, const std::vector<double>& times)
      : crossings_(level, plan, false), hazard_time_(hazard_time), times_(times) {
    sums_.excess.resize(times.size());
  }

  /// Adds a round of a stream.
  void add_round(Simulation& simulation, std::size_t stream) {
    crossings_.add_round(
        simulation, stream, [this](double time) { end_stay(time); },
        [this](double time) { begin_stay(time); });
    if (!closing_) sums_.whole = crossings_.elapsed_time();
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
    for (std::size_t k = 0; k < times_.size(); ++k) {
      sums_.excess[k] += std::max(0.0, stay - times_[k]);
    }
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

  TrajectoryBarrierCrossings crossings_;
  double hazard_time_;
  const std::vector<double>& times_;
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

// Simulates the stationary process until the standard error is at most kGoal, and returns the sums
// of all streams; empty if a stay lasts as long as the simulation.
std::optional<std::vector<BelowBarrierSojournSums>> simulate_stays(
    Simulation& simulation, const PassageLevel& level, double hazard_time,
    const std::vector<double>& times, const SimulationOptions& options) {
  const SimulationPlan& plan = simulation.plan_of_simulation();
  const auto streams = static_cast<std::size_t>(plan.streams);
  std::vector<BelowBarrierSojournCounter> counters(streams, {level, plan, hazard_time, times});
  const auto simulate_and_sample_one_round = [&] {
    simulation.simulate_and_sample_one_round();
    base::parallel_for(streams, plan.threads,
                       [&](std::size_t s) { counters[s].add_round(simulation, s); });
  };
  const auto all_sums = [&] {
    std::vector<BelowBarrierSojournSums> sums;
    for (const BelowBarrierSojournCounter& counter : counters) sums.push_back(counter.sums());
    return sums;
  };
  simulation.run_burn_in();
  for (std::uint64_t round = 0; round < plan.rounds; ++round) {
    simulate_and_sample_one_round();
    if (options.progress) {
      options.progress({static_cast<double>(round + 1) / static_cast<double>(plan.rounds) / 2});
    }
    const auto sums = all_sums();
    const ValueWithError mean = mean_time_from_stationary(sums);
    if (!options.time && stay_count(sums) >= kFewestStaysAtGoal &&
        mean.error <= kGoal * mean.value) {
      break;
    }
  }
  for (BelowBarrierSojournCounter& counter : counters) counter.stop_counting();
  const std::uint64_t most_rounds = plan.rounds;  // a stay may last as long as the simulation
  for (std::uint64_t round = 0;
       round < most_rounds &&
       std::ranges::any_of(counters, &BelowBarrierSojournCounter::has_open_stay);
       ++round) {
    simulate_and_sample_one_round();
  }
  if (std::ranges::any_of(counters, &BelowBarrierSojournCounter::has_open_stay))
    return std::nullopt;
  return all_sums();
}

// Simulates passages from a state in wall coordinates, to which each stream returns in the round
// after a passage. Every stream makes the same number of passages, since a limit of the simulated
// time would favour short passages.
// Sets the values of `result` for the start from a point; the mean time is absent if the passages
// take too long.
void simulate_passages_from_point(Simulation& simulation, const PassageLevel& level,
                                  const transform::PassageStartState& start, double mean,
                                  double most_time, const std::vector<double>& times,
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
      if (passage) {
        if (found[s].size() < passages) found[s].push_back(*passage);
        crossings[s] = at_start;
        simulation.restart_trajectory_stream(s, start.y, start.ydot);
      }
      finished += found[s].size() >= passages ? 1 : 0;
    }
    if (options.progress) {
      options.progress({0.5 + 0.5 * static_cast<double>(finished) / static_cast<double>(streams)});
    }
  }
  // Returns the mean of f(passage) over all passages, with the standard error of the mean.
  const auto mean_of = [&](const std::function<double(const Passage&)>& f) -> ValueWithError {
    double sum = 0, square = 0;
    const double n = static_cast<double>(streams) * per_stream;
    for (const auto& of_stream : found) {
      for (const Passage& passage : of_stream) {
        sum += f(passage);
        square += f(passage) * f(passage);
      }
    }
    return {sum / n, std::sqrt(std::max(0.0, square / n - sum / n * (sum / n)) / (n - 1))};
  };
  for (const double t : times) {
    result.survival_from_point.push_back(
        mean_of([t](const Passage& passage) { return passage.time > t ? 1.0 : 0.0; }));
  }
  result.mean_from_point = mean_of([](const Passage& passage) { return passage.time; });
  const auto* barriers = std::get_if<DisplacementBarriers>(&level);
  if (barriers != nullptr && barriers->are_two) {
    result.upper_exit_from_point =
        mean_of([](const Passage& passage) { return passage.is_upper ? 1.0 : 0.0; });
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

EnergyLevelForPassage energy_passage_level(const problem::Problem& transformed,
                                           const SimulationPlan& plan,
                                           const problem::MotionScales& scales, double energy) {
  const bool even = plan.excitation.arrivals == ImpulseProcess::Arrivals::even;
  return {.potential = {transformed, scales},
          .level = transform::energy_level_in_wall_coordinates(transformed, energy),
          .impulse_variance = even ? plan.excitation.width * plan.excitation.width : 0,
          .has_noise = even || plan.kicks.is_acting()};
}

bool is_below(const transform::PassageStartState& state, const EnergyLevelForPassage& energy) {
  return state.ydot * state.ydot / 2 + energy.potential(state.y) < energy.level;
}

}  // namespace

transform::FirstPassageResult estimate_passage(const problem::Problem& problem,
                                               const SimulationOptions& options,
                                               const transform::PassageBarrier& barrier,
                                               const std::vector<double>& times,
                                               std::optional<transform::PassageStartState> start) {
  const base::Stopwatch stopwatch;
  transform::FirstPassageResult passage{.id = solution_id(options)};
  passage.has_standard_errors = true;
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  passage.reason = unsupported_functional_reason(transformed, options);
  if (passage.reason.empty()) passage.reason = unsupported_barrier_reason(transformed, barrier);
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  const problem::MotionScales scales = problem::motion_scales(transformed);
  const bool is_energy = barrier.is_energy();
  const double displacement = transformed.frame.wall_coordinate(barrier.level);
  const SimulationPlan plan =
      make_passage_plan(transformed, options, scales, distance_to_wall(transformed, barrier));
  const PassageLevel level = is_energy
                                 ? energy_passage_level(transformed, plan, scales, barrier.level)
                                 : PassageLevel(displacement_barriers(transformed.frame, barrier));
  const auto enable_records = [&](Simulation& simulation) {
    is_energy ? simulation.enable_state_recording() : simulation.enable_displacement_recording();
  };
  Simulation stationary(transformed, plan);
  enable_records(stationary);
  const auto found =
      simulate_stays(stationary, level, kDecayTimes / scales.slowest_decay_rate, times, options);
  const double stays = found ? stay_count(*found) : 0;
  if (stays < kFewestStays) {
    passage.reason =
        found ? fmt::format("only {} passages in the simulated time; increase --time", stays)
              : "a stay below the barrier lasted longer than the simulation; increase --time";
    passage.status = Status::not_converged;
    passage.seconds = stopwatch.seconds();
    return passage;
  }
  const std::vector<BelowBarrierSojournSums>& sums = *found;
  // Under noise the barrier of the stays is shifted. The mean time from a state between the shifted
  // and the given barrier is 0, so that the means refer to the time below the given barrier.
  const bool is_shifted = std::holds_alternative<EnergyLevelForPassage>(level) &&
                          std::get<EnergyLevelForPassage>(level).has_noise;
  const auto length = [is_shifted](const BelowBarrierSojournSums& s) {
    return is_shifted ? s.below : s.length;
  };
  const auto whole = [](const BelowBarrierSojournSums& s) { return s.whole; };
  passage.mean_from_stationary = ratio_of_sums(
      sums, [](const BelowBarrierSojournSums& s) { return s.square / 2; }, length);
  double long_stays = 0;
  for (const BelowBarrierSojournSums& s : sums) long_stays += s.long_stays;
  if (long_stays >= kFewestStays) {
    passage.hazard = ratio_of_sums(
        sums, [](const BelowBarrierSojournSums& s) { return s.long_stays; },
        [](const BelowBarrierSojournSums& s) { return s.longer; });
  }
  if (!is_energy) {
    passage.rice_rate = ratio_of_sums(
        sums, [](const BelowBarrierSojournSums& s) { return s.crossings; }, whole);
  }
  passage.probability_below = ratio_of_sums(
      sums, [](const BelowBarrierSojournSums& s) { return s.below; }, whole);
  if (barrier.lower_level) {
    passage.upper_exit_from_stationary = ratio_of_sums(
        sums, [](const BelowBarrierSojournSums& s) { return s.length_to_upper; }, length);
  }
  passage.times = times;
  for (std::size_t k = 0; k < times.size(); ++k) {
    passage.survival_from_stationary.push_back(ratio_of_sums(
        sums, [k](const BelowBarrierSojournSums& s) { return s.excess[k]; }, length));
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
    const double mean = passage.mean_from_stationary->value;
    from_point.samples_per_round = static_cast<std::uint64_t>(
        std::ceil(std::min(mean / 10 / plan.sampling_interval, most_samples_per_round(plan))));
    Simulation restarted(transformed, from_point);
    enable_records(restarted);
    simulate_passages_from_point(restarted, level, *start, mean, sums.front().whole * plan.streams,
                                 times, options, passage);
  }
  passage.details = fmt::format("{:.0f} stays below the barrier", stays);
  passage.reason = short_burn_in_reason(plan, options);
  passage.status = passage.reason.empty() ? Status::ok : Status::not_converged;
  // At low levels and high noise intensities the means are up to 8 % too large (case 1 with
  // noise.intensity = 0.1, level 0.05).
  if (is_shifted && passage.status == Status::ok) {
    passage.status = Status::inaccurate;
    passage.reason =
        "passages of the energy between noise kicks are found approximately, and the error of this "
        "approximation is unknown; use fd";
  }
  passage.seconds = stopwatch.seconds();
  return passage;
}

}  // namespace fpkcheck::mcs
