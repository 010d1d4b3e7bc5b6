#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "mcs/motion/advance_trajectories.hpp"
#include "mcs/simulation/simulation_plan.hpp"

namespace fpkcheck::mcs {

/// Simulation of the independent streams (realisations) of a plan, in rounds of simulated time. The
/// statistics do not depend on the number of threads, since each thread advances whole streams.
class Simulation {
 public:
  /// Creates the streams at the beginning of their burn-in. Initial states are drawn from the
  /// Gaussian of equivalent linearisation, folded to y >= 0 by paper (5), or by
  /// InitialStateSampler.
  /// @param plan must outlive the simulation
  /// @param splitting null, or must outlive the simulation
  Simulation(const problem::Problem& problem, const SimulationPlan& plan,
             const ImportanceSplitting* splitting = nullptr);

  /// Restricts this simulation to every `part_count`-th group of streams, beginning with group
  /// `part`. load_streams_of_process() reads the streams of the other parts.
  void keep_streams_of_process(int part, int part_count);

  /// Replaces the splitting and clears the histogram of the energies after impulses.
  /// @param splitting must outlive the simulation
  void set_importance_splitting(const ImportanceSplitting& splitting);

  /// From now on, simulate_and_sample_one_round() appends the samples of y to
  /// TrajectoryStream::series.
  /// @pre no splitting
  void enable_displacement_recording();
  /// From now on, simulate_and_sample_one_round() appends states to TrajectoryStream::states.
  /// @pre no splitting, and no multiplicative noise
  void enable_state_recording();

  /// Advances all streams by the burn-in time, without statistics.
  void run_burn_in();
  /// Advances all streams by one round, and adds to their statistics.
  void simulate_and_sample_one_round();
  /// Advances all streams from the time `from` to the time `to` with the excitation at these times,
  /// without statistics and series.
  void advance_streams_between_times(double from, double to);
  /// Sets the state of a trajectory stream to (y, v). The next sample is half a sampling interval
  /// later, and the next impulse comes after a new waiting time.
  void restart_trajectory_stream(std::size_t stream, double y, double v);

  const SimulationPlan& plan_of_simulation() const { return *plan_; }
  std::uint64_t sampling_round_count() const { return rounds_; }
  /// Returns the simulated time of one trajectory stream, without the burn-in.
  double simulated_time_per_stream() const {
    return static_cast<double>(rounds_) * plan_->simulated_time_per_round();
  }
  /// Returns the expected sum of the sample weights of one trajectory stream; without importance
  /// splitting the sum equals its expectation.
  double expected_samples_per_stream() const {
    return static_cast<double>(rounds_) * static_cast<double>(plan_->samples_per_round);
  }
  const std::vector<TrajectoryStream>& trajectory_streams() const { return streams_; }
  /// Returns the samples of y of a trajectory stream; the caller removes samples after use.
  std::vector<double>& displacement_series(std::size_t stream) { return streams_[stream].series; }
  /// Returns the recorded states of a stream; the caller removes states after use.
  std::vector<RecordedState>& recorded_states(std::size_t stream) {
    return streams_[stream].states;
  }

  /// Writes the complete state of the simulation between two rounds.
  void save_state(std::ostream& out) const;
  /// Reads a simulation state that save_state() wrote.
  /// @throws InputError if the input is not a state with the same numbers of streams and bins
  void load_state(std::istream& in);

  /// Writes the states of those streams that this process simulates.
  void save_streams_of_this_process(std::ostream& out) const;
  /// Reads the streams of a part that save_streams_of_this_process() wrote.
  /// @throws InputError as load_state()
  void load_streams_of_process(std::istream& in, int part);

 private:
  void advance_trajectory_streams(bool recorded, double time);
  std::array<double, 2> contact_forces_at_time(double t) const;
  void set_contact_forces(double t);
  bool is_stream_of_process(int part, std::size_t stream) const;
  void save_stream(std::ostream& out, const TrajectoryStream& stream) const;
  void load_stream(std::istream& in, TrajectoryStream& stream) const;

  const SimulationPlan* plan_;
  StreamMotionParameters motion_;
  std::uint64_t rounds_ = 0;
  int part_ = 0, parts_ = 1;
  std::vector<TrajectoryStream> streams_;
};

/// Returns value(statistics) of each trajectory stream.
template <class Value>
std::vector<double> statistic_of_each_stream(const std::vector<TrajectoryStream>& streams,
                                             Value value) {
  std::vector<double> values;
  for (const TrajectoryStream& stream : streams) values.push_back(value(stream.record));
  return values;
}

}  // namespace fpkcheck::mcs
