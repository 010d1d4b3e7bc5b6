#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "mcs/motion/advance_trajectories.hpp"
#include "mcs/simulation/simulation_plan.hpp"

namespace fpkcheck::mcs {

/// Simulation of the independent trajectory streams (realisations) of a SimulationPlan, in rounds
/// of simulated time. The statistics of the simulation do not depend on the number of threads,
/// since each thread advances whole streams.
class Simulation {
 public:
  /// Creates the trajectory streams at the beginning of their burn-in. Initial states are drawn
  /// from the Gaussian of equivalent linearisation, folded to y >= 0 by paper (5), or by
  /// InitialStateSampler.
  /// @param plan must outlive the simulation
  /// @param splitting null without importance splitting; otherwise must outlive the simulation
  Simulation(const problem::Problem& problem, const SimulationPlan& plan,
             const ImportanceSplitting* splitting = nullptr);

  /// Restricts the simulation to every `part_count`-th group of trajectory streams, beginning with
  /// group `part`. load_streams_of_process() reads the trajectory streams of the other processes.
  void keep_streams_of_process(int part, int part_count);

  /// Replaces the importance splitting and clears the histogram of the energies after impulses.
  /// @param splitting must outlive the simulation
  void set_importance_splitting(const ImportanceSplitting& splitting);

  /// After this call, simulate_and_sample_one_round() appends the samples of y to
  /// TrajectoryStream::series.
  /// @pre no splitting
  void enable_displacement_recording();
  /// After this call, simulate_and_sample_one_round() appends oscillator states to
  /// TrajectoryStream::states.
  /// @pre no splitting, and no multiplicative noise
  void enable_state_recording();

  /// Advances all trajectory streams by the burn-in time, without recording statistics.
  void run_burn_in();
  /// Advances all trajectory streams by one round of simulated time, and records statistics.
  void simulate_and_sample_one_round();
  /// Advances all trajectory streams from the time `from` to the time `to` under a time-dependent
  /// excitation, without recording statistics and time series.
  void advance_streams_between_times(double from, double to);
  /// Sets the state of a trajectory stream to (y, v). After a restart the first sample is taken
  /// half a sampling interval later, and the first impulse comes after a new waiting time.
  void restart_trajectory_stream(std::size_t stream, double y, double v);
  /// Continues a branch of any stream between two rounds in the given stream, with new random
  /// numbers after the present time: new impulses at new times, unless the impulses are evenly
  /// spaced.
  void continue_branch(std::size_t stream, const TrajectoryBranch& branch);

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
  /// Returns the recorded states of a trajectory stream; the caller removes states after use.
  std::vector<RecordedState>& recorded_states(std::size_t stream) {
    return streams_[stream].states;
  }

  /// Writes the complete state of the simulation between two rounds.
  void save_state(std::ostream& out) const;
  /// Reads a simulation state that save_state() wrote.
  /// @throws InputError if the input is no state with the same numbers of streams and bins
  void load_state(std::istream& in);

  /// Writes the states of the trajectory streams that the present process simulates.
  void save_streams_of_this_process(std::ostream& out) const;
  /// Reads the trajectory streams of another process, which save_streams_of_this_process() wrote.
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

/// Returns the value of a function of the statistics for each trajectory stream.
template <class Value>
std::vector<double> statistic_of_each_stream(const std::vector<TrajectoryStream>& streams,
                                             Value value) {
  std::vector<double> values;
  for (const TrajectoryStream& stream : streams) values.push_back(value(stream.record));
  return values;
}

}  // namespace fpkcheck::mcs
