#include "mcs/passage/rare_passages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "base/process/parallel_for.hpp"
#include "problem/effective_potential.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kSplittingStreams = 16;               // streams of a replication
constexpr std::uint64_t kSamplesBetweenChecks = 2;  // samples between comparisons with the levels
constexpr double kFractionAboveBase = 0.1;          // fraction of the time above the lowest level
constexpr double kFractionAtNextLevel = 0.25;
constexpr std::size_t kTrajectories = 500;  // trajectories of a stage in a replication
constexpr std::size_t kPilotTrajectories = 1000;
constexpr std::size_t kMostLevels = 60;
constexpr std::size_t kReplicationsPerBatch = 16, kFewestReplications = 32;

// Stays below the barrier that begin during an excursion.
class ExcursionStays {
 public:
  void on_upcrossing(double time, double longest_stay) {
    if (begin_) add_stay(time, longest_stay);
    if (is_over_) return;
    ++crossings_;
    above_since_ = time;
  }
  void on_downcrossing(double time) {
    if (is_over_) return;
    time_above_ += time - above_since_;
    begin_ = time;
  }
  void end_excursion() { is_over_ = true; }

  bool is_excursion_over() const { return is_over_; }
  /// Returns whether no stay is open, or ends the open stay if it is longer than the longest stay.
  bool is_finished(double time, double longest_stay) {
    if (begin_ && time - *begin_ >= longest_stay) add_stay(time, longest_stay);
    return is_over_ && !begin_;
  }
  std::uint64_t crossings() const { return crossings_; }
  double time_above() const { return time_above_; }
  const std::vector<double>& stays() const { return stays_; }

 private:
  void add_stay(double end, double longest_stay) {
    stays_.push_back(std::min(end - *begin_, longest_stay));
    begin_.reset();
  }

  std::vector<double> stays_;
  std::uint64_t crossings_ = 0;
  double time_above_ = 0, above_since_ = 0;
  std::optional<double> begin_ = {};  // begin of the open stay
  bool is_over_ = false;
};

// A trajectory in an excursion.
struct Trajectory {
  TrajectoryBranch branch;
  TrajectoryBarrierCrossings crossings;
  ExcursionStays stays = {};
  double earlier_time_above = 0;  // time_above_energy() before the excursion
};

// Returns the time above an energy level without its shift; 0 for a displacement.
double time_above_energy(const TrajectoryBarrierCrossings& crossings) {
  const auto below = crossings.time_below_energy();
  return below ? crossings.elapsed_time() - *below : 0;
}

// One replication of the splitting, with random numbers of its own.
class SplittingReplication {
 public:
  SplittingReplication(const problem::Problem& problem, const SimulationPlan& plan,
                       std::uint64_t number, const PassageLevel& barrier,
                       const TabulatedPotential& potential, double longest_stay, double most_time)
      : plan_(with_own_seed(plan, number)),
        simulation_(problem, plan_),
        barrier_(&barrier),
        potential_(&potential),
        longest_stay_(longest_stay),
        most_time_(most_time),
        random_(plan_.seed) {
    std::holds_alternative<EnergyLevelForPassage>(barrier)
        ? simulation_.enable_state_recording()
        : simulation_.enable_displacement_recording();
    simulation_.run_burn_in();
  }

  double simulated_time() const {
    return simulation_.simulated_time_per_stream() * kSplittingStreams;
  }

  /// Returns the energies of the stationary process at checks, for the time `time` of each stream.
  std::vector<double> stationary_energies(double time) {
    std::vector<double> energies;
    for (double t = 0; t < time; t += plan_.simulated_time_per_round()) {
      run_round();
      for (const TrajectoryStream& stream : simulation_.trajectory_streams()) {
        energies.push_back(energy(stream.branch));
      }
    }
    return energies;
  }

  struct Beginnings {
    std::vector<Trajectory> states;
    double rate;  // number of beginnings per unit time
  };
  /// Simulates the stationary process for the time `time` of each stream.
  /// @return states at the beginnings of excursions
  Beginnings simulate_beginnings(double base, double time) {
    std::vector<Trajectory> found, streams(kSplittingStreams, new_trajectory());
    std::vector<bool> away(kSplittingStreams, true);
    double total = 0;
    for (; total < time; total += plan_.simulated_time_per_round()) {
      simulation_.simulate_and_sample_one_round();
      for (std::size_t s = 0; s < streams.size(); ++s) {
        add_round(s, streams[s]);
        const bool is_in_base = is_below_base(streams[s], base);
        if (!away[s] && (!is_in_base || streams[s].stays.crossings() > 0)) {
          found.push_back(streams[s]);
          away[s] = true;
        } else if (is_in_base) {
          away[s] = false;
        }
        if (is_in_base) {
          streams[s].stays = {};
          streams[s].earlier_time_above = time_above_energy(streams[s].crossings);
        }
      }
    }
    return {found, static_cast<double>(found.size()) / (total * kSplittingStreams)};
  }

  /// Simulates `count` trajectories from the given states until is_finished(trajectory, number) is
  /// true, which is called at the beginning and at every check.
  /// @return whether all trajectories are finished
  template <class IsFinished>
  bool run_stage(const std::vector<Trajectory>& starts, std::size_t count,
                 const IsFinished& is_finished) {
    struct NumberedTrajectory {
      std::size_t number;
      Trajectory trajectory;
    };
    std::vector<std::optional<NumberedTrajectory>> active(kSplittingStreams);
    // Systematic resampling: the numbers of trajectories from two states differ by at most 1.
    const double offset = static_cast<double>(random_() >> 11) * 0x1p-53;
    std::size_t next = 0;
    const auto start_next = [&](std::size_t s) {
      active[s].reset();
      while (!active[s] && next < count) {
        const std::size_t number = next++;
        const double position = (static_cast<double>(number) + offset) /
                                static_cast<double>(count) * static_cast<double>(starts.size());
        Trajectory start = starts[std::min(static_cast<std::size_t>(position), starts.size() - 1)];
        if (is_finished(start, number)) continue;
        simulation_.continue_branch(s, start.branch);
        active[s] = {number, std::move(start)};
      }
    };
    for (std::size_t s = 0; s < active.size(); ++s) start_next(s);
    while (std::ranges::any_of(active, [](const auto& one) { return one.has_value(); })) {
      if (simulated_time() > most_time_) return false;
      simulation_.simulate_and_sample_one_round();
      for (std::size_t s = 0; s < active.size(); ++s) {
        if (!active[s]) {
          clear_records(s);
          continue;
        }
        auto& [number, trajectory] = *active[s];
        add_round(s, trajectory);
        if (is_finished(trajectory, number)) start_next(s);
      }
    }
    return true;
  }

  double energy(const TrajectoryBranch& branch) const {
    return branch.v * branch.v / 2 + (*potential_)(branch.y);
  }
  bool is_below_base(const Trajectory& trajectory, double base) const {
    return energy(trajectory.branch) < base && !trajectory.crossings.is_above();
  }
  /// Returns the energy of a trajectory, or infinity after a passage.
  double height(const Trajectory& trajectory) const {
    return trajectory.stays.crossings() > 0 ? std::numeric_limits<double>::infinity()
                                            : energy(trajectory.branch);
  }

  /// Continues excursions to their end, and the last stay of each excursion to the longest stay.
  /// @return empty if the simulated time is too short
  std::optional<RarePassages> run_last_stage(const std::vector<Trajectory>& starts, double base) {
    RarePassages passages;
    const bool is_complete =
        run_stage(starts, kTrajectories, [&](Trajectory& trajectory, std::size_t) {
          ExcursionStays& stays = trajectory.stays;
          if (!stays.is_excursion_over() && is_below_base(trajectory, base)) {
            stays.end_excursion();
            passages.time_above_given_barrier +=
                std::holds_alternative<EnergyLevelForPassage>(*barrier_)
                    ? time_above_energy(trajectory.crossings) - trajectory.earlier_time_above
                    : stays.time_above();
          }
          if (!stays.is_finished(trajectory.crossings.elapsed_time(), longest_stay_)) return false;
          passages.crossings += stays.crossings();
          passages.time_above += stays.time_above();
          passages.stays.insert(passages.stays.end(), stays.stays().begin(), stays.stays().end());
          return true;
        });
    return is_complete ? std::optional(passages) : std::nullopt;
  }

 private:
  static SimulationPlan with_own_seed(SimulationPlan plan, std::uint64_t number) {
    constexpr std::uint64_t kOddConstant = 0x9E3779B97F4A7C15;  // 2^64 divided by the golden ratio
    plan.seed += (number + 1) * kOddConstant;
    return plan;
  }

  Trajectory new_trajectory() const {
    return {{}, TrajectoryBarrierCrossings(*barrier_, plan_, false)};
  }

  void clear_records(std::size_t s) {
    simulation_.displacement_series(s).clear();
    simulation_.recorded_states(s).clear();
  }
  void run_round() {
    simulation_.simulate_and_sample_one_round();
    for (std::size_t s = 0; s < kSplittingStreams; ++s) clear_records(s);
  }
  void add_round(std::size_t s, Trajectory& trajectory) {
    trajectory.crossings.add_round(
        simulation_, s, [&](double time) { trajectory.stays.on_upcrossing(time, longest_stay_); },
        [&](double time) { trajectory.stays.on_downcrossing(time); });
    trajectory.branch = simulation_.trajectory_streams()[s].branch;
  }

  SimulationPlan plan_;
  Simulation simulation_;
  const PassageLevel* barrier_;
  const TabulatedPotential* potential_;
  double longest_stay_, most_time_;
  std::mt19937_64 random_;
};

double upper_quantile(std::vector<double> values, double fraction_above) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((1 - fraction_above) *
                                                               static_cast<double>(values.size()));
  std::ranges::nth_element(values, at);
  return *at;
}

// Chooses the levels: a stage simulates trajectories until the end of their excursions, and the
// next level is the energy that the fraction kFractionAtNextLevel of the trajectories exceeds.
// @param time simulated time of each stream of the stationary process
// @return levels; empty if the levels do not lead to the barrier
std::vector<double> choose_levels(SplittingReplication& pilot, double time) {
  std::vector<double> levels{upper_quantile(pilot.stationary_energies(time), kFractionAboveBase)};
  std::vector<Trajectory> states = pilot.simulate_beginnings(levels.front(), time).states;
  while (!states.empty() && levels.size() < kMostLevels) {
    // States at which the height of each trajectory has a new maximum
    struct Maximum {
      double height;  // energy, or infinity after a passage
      Trajectory state;
    };
    std::vector<std::vector<Maximum>> maxima(kPilotTrajectories);
    const bool is_complete = pilot.run_stage(
        states, kPilotTrajectories, [&](Trajectory& trajectory, std::size_t number) {
          const double height = pilot.height(trajectory);
          auto& own = maxima[number];
          if (own.empty() || height > own.back().height) own.push_back({height, trajectory});
          return std::isinf(height) || pilot.is_below_base(trajectory, levels.front());
        });
    if (!is_complete) return {};
    std::vector<double> heights;
    for (const auto& own : maxima) heights.push_back(own.back().height);
    const double next = upper_quantile(heights, kFractionAtNextLevel);
    if (std::isinf(next)) return levels;
    if (!(next > levels.back())) return {};
    levels.push_back(next);
    states.clear();
    for (auto& own : maxima) {
      const auto first = std::ranges::find_if(
          own, [next](const Maximum& maximum) { return maximum.height >= next; });
      if (first != own.end()) states.push_back(std::move(first->state));
    }
  }
  return {};
}

// Returns the passages of one replication; empty if the simulated time is too short.
std::optional<RarePassages> simulate_replication(SplittingReplication& replication,
                                                 const std::vector<double>& levels, double time) {
  auto [states, weight] = replication.simulate_beginnings(levels.front(), time);
  for (std::size_t k = 1; k < levels.size() && !states.empty(); ++k) {
    std::vector<Trajectory> next;
    const bool is_complete =
        replication.run_stage(states, kTrajectories, [&](Trajectory& trajectory, std::size_t) {
          const bool is_successful = replication.height(trajectory) >= levels[k];
          if (is_successful) next.push_back(trajectory);
          return is_successful || replication.is_below_base(trajectory, levels.front());
        });
    if (!is_complete) return std::nullopt;
    weight *= static_cast<double>(next.size()) / static_cast<double>(kTrajectories);
    states = std::move(next);
  }
  if (states.empty()) return RarePassages{};
  auto passages = replication.run_last_stage(states, levels.front());
  if (passages) passages->weight = weight / static_cast<double>(kTrajectories);
  return passages;
}

}  // namespace

RarePassageRun simulate_rare_passages(
    const problem::Problem& problem, const SimulationPlan& plan, const PassageLevel& barrier,
    const problem::MotionScales& scales, double longest_stay, double most_time,
    const std::function<bool(const std::vector<RarePassages>&)>& is_precise) {
  constexpr double kBurnIns = 3;  // simulated time of the stationary process, in burn-in times
  const auto* energy = std::get_if<EnergyLevelForPassage>(&barrier);
  const TabulatedPotential potential =
      energy != nullptr ? energy->potential
                        : TabulatedPotential(problem::EffectivePotential(problem), scales);
  SimulationPlan own = plan;
  own.streams = kSplittingStreams;
  own.threads = 1;  // the replications are simulated in parallel
  own.samples_per_round = kSamplesBetweenChecks;
  // Each replication of a batch has a limit of its own, so that a batch takes at most twice the time
  // `most_time`.
  const auto make_replication = [&](std::uint64_t number) {
    return SplittingReplication(problem, own, number, barrier, potential, longest_stay,
                                2 * most_time / kReplicationsPerBatch);
  };
  RarePassageRun run;
  SplittingReplication pilot = make_replication(0);
  const std::vector<double> levels = choose_levels(pilot, kBurnIns * plan.burn_in);
  run.simulated_time = pilot.simulated_time();
  run.levels = levels.size();
  while (!levels.empty() &&
         (run.simulated_time < most_time || run.replications.size() < kFewestReplications)) {
    std::vector<std::optional<RarePassages>> batch(kReplicationsPerBatch);
    std::vector<double> times(kReplicationsPerBatch);
    base::parallel_for(batch.size(), plan.threads, [&](std::size_t r) {
      SplittingReplication replication = make_replication(1 + run.replications.size() + r);
      batch[r] = simulate_replication(replication, levels, kBurnIns * plan.burn_in);
      times[r] = replication.simulated_time();
    });
    for (const double time : times) run.simulated_time += time;
    for (auto& passages : batch) {
      if (!passages) return {.simulated_time = run.simulated_time};
      run.replications.push_back(*std::move(passages));
    }
    if (run.replications.size() >= kFewestReplications && is_precise(run.replications)) break;
  }
  if (run.replications.size() < kFewestReplications) run.replications.clear();
  return run;
}

}  // namespace fpkcheck::mcs
