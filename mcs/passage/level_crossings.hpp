#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "mcs/simulation/simulation.hpp"
#include "problem/effective_potential.hpp"
#include "problem/motion_scales.hpp"

/// Crossings of a barrier by the simulated streams.
namespace fpkcheck::mcs {

/// Finds the crossings of a level in evenly spaced samples, by linear interpolation between
/// samples. A parabola through three samples finds excursions above the level between samples.
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

/// A potential: a polynomial, or a table of the potential of a formula. Without the table, each
/// value of the potential would take ten evaluations of the formula.
class TabulatedPotential {
 public:
  TabulatedPotential(const problem::EffectivePotential& potential,
                     const problem::MotionScales& scales)
      : potential_(potential), low_(scales.y_low) {
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

/// An energy level in wall coordinates.
struct EnergyLevelForPassage {
  TabulatedPotential potential;
  double level;
  /// Variance of the velocity change by an impulse, if evenly spaced impulses replace white noise
  double impulse_variance;
  bool has_noise;  ///< whether noise kicks or evenly spaced impulses change the energy
};

/// Finds the crossings of an energy level in the recorded states of a stream.
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

/// Barriers of the displacement in wall coordinates: y = centre + half_width and, with two barriers,
/// y = centre - half_width. With one barrier the centre is 0.
struct DisplacementBarriers {
  double half_width;
  double centre = 0;
  bool are_two = false;

  /// Returns the function of the displacement y whose upcrossings of `half_width` are the passages.
  double distance(double y) const { return are_two ? std::abs(y - centre) : y; }
};

/// A barrier in wall coordinates: displacements or an energy level.
using PassageLevel = std::variant<DisplacementBarriers, EnergyLevelForPassage>;

/// Finds the crossings of a barrier in the rounds of one stream.
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

}  // namespace fpkcheck::mcs
