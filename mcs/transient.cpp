#include "mcs/transient.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stopwatch.hpp"
#include "mcs/applicability.hpp"
#include "mcs/estimate/kick_interval_error.hpp"
#include "mcs/motion/taylor_flight.hpp"
#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "numerics/statistics.hpp"
#include "problem/initial_density.hpp"
#include "problem/motion_scales.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::Moments;
using transform::Status;
using transform::TransientRequest;

// Number of paths of the default simulation, and largest number of its impulses, kicks and flights,
// with DuffingFlights and with other flights: some seconds of computing
constexpr double kPaths = 1e6, kMostDuffingEvents = 6e7, kMostOtherEvents = 2.5e7;
constexpr double kFewestPaths = 1000;
constexpr int kStreams = 2048;  // paths that are simulated together

// Histograms and sums of powers of y and y' over simulated paths, at one time.
struct SnapshotHistograms {
  std::vector<double> y, v;                      // number of paths in each bin, outer bins included
  std::array<double, 8> y_powers{}, v_powers{};  // sums of the powers 1 .. 8

  SnapshotHistograms(const BinFinder& y_bins, const BinFinder& v_bins)
      : y(y_bins.bin_count() + 2), v(v_bins.bin_count() + 2) {}

  void add_path(const BinFinder& y_bins, const BinFinder& v_bins, double at_y, double at_v) {
    ++y[y_bins(at_y)];
    ++v[v_bins(at_v)];
    double y_power = 1, v_power = 1;
    for (std::size_t k = 0; k < y_powers.size(); ++k) {
      y_powers[k] += y_power *= at_y;
      v_powers[k] += v_power *= at_v;
    }
  }

  void add_sums(const SnapshotHistograms& other) {
    const auto plus = [](auto& a, const auto& b) {
      std::ranges::transform(a, b, a.begin(), std::plus());
    };
    plus(y, other.y);
    plus(v, other.v);
    plus(y_powers, other.y_powers);
    plus(v_powers, other.v_powers);
  }
};

// Generator of independent initial states from a Gaussian that is truncated at the walls.
class InitialStateGenerator {
 public:
  InitialStateGenerator(const problem::System& system, const problem::InitialGaussian& density,
                        std::uint64_t seed)
      : left_(system.left_wall() ? system.left_wall()->position : -HUGE_VAL),
        right_(system.right_wall() ? system.right_wall()->position : HUGE_VAL),
        density_(density) {
    const auto probability = [&](double y) {
      return numerics::normal_probability((y - density.mean_displacement) /
                                          density.displacement_deviation);
    };
    if (std::isfinite(left_)) left_probability_ = probability(left_);
    if (std::isfinite(right_)) right_probability_ = probability(right_);
    for (std::uint32_t stream = 0; stream < kStreams; ++stream) {
      normal_.emplace_back(standard_normal_number_process(), seed, stream,
                           RandomNumberPurpose::start);
    }
  }

  OscillatorState draw_state(std::size_t stream) {
    const auto next = [&] { return normal_[stream].next_impulse().amplitude; };
    // The initial displacement is the quantile of a probability that is uniform between the
    // probabilities of the two walls.
    const double below = left_probability_;
    const double probability =
        below + numerics::normal_probability(next()) * (right_probability_ - below);
    const double deviations =
        boost::math::quantile(boost::math::normal(), std::clamp(probability, kLeast, 1 - kLeast));
    const double y = std::clamp(
        density_.mean_displacement + density_.displacement_deviation * deviations, left_, right_);
    return {.y = y, .v = density_.mean_velocity + density_.velocity_deviation * next()};
  }

 private:
  static constexpr double kLeast = 1e-15;  // least probability with a finite quantile

  double left_, right_;
  problem::InitialGaussian density_;
  double left_probability_ = 0, right_probability_ = 1;
  std::vector<ImpulseSource> normal_;
};

transform::Marginal make_marginal(const std::vector<double>& counts,
                                  const std::vector<double>& edges, double paths,
                                  double& expected_l1) {
  transform::Marginal marginal{.edges = edges, .density = {}, .lower = {}, .upper = {}};
  expected_l1 = 0;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const double width = edges[b + 1] - edges[b], probability = counts[b + 1] / paths;
    const double error = std::sqrt(probability * (1 - probability) / paths);
    // Wilson's confidence interval of a probability, which has a positive width even for an empty
    // bin
    const double z2 = numerics::kNormal95 * numerics::kNormal95 / paths;
    const double centre = (probability + z2 / 2) / (1 + z2);
    const double half =
        numerics::kNormal95 * std::sqrt(error * error + z2 / (4 * paths)) / (1 + z2);
    marginal.density.push_back(probability / width);
    marginal.lower.push_back(std::max(0.0, centre - half) / width);
    marginal.upper.push_back((centre + half) / width);
    // sqrt(2/pi) times the standard error is the mean absolute value of a normal error.
    expected_l1 += std::sqrt(2 / std::numbers::pi) * error;
  }
  return marginal;
}

transform::TransientDensitySnapshot make_snapshot(const SnapshotHistograms& sums, double time,
                                                  double paths, const TransientRequest& request) {
  transform::TransientDensitySnapshot snapshot{.time = time};
  transform::ErrorEstimate& error = snapshot.error.emplace();
  const auto set = [&](double Moments::*moment, const std::array<double, 8>& powers, int power) {
    const double mean = powers[power - 1] / paths, square = powers[2 * power - 1] / paths;
    snapshot.moments.*moment = mean;
    error.moments.*moment = std::sqrt(std::max(0.0, square - mean * mean) / (paths - 1));
  };
  set(&Moments::y1, sums.y_powers, 1);
  set(&Moments::y2, sums.y_powers, 2);
  set(&Moments::y4, sums.y_powers, 4);
  set(&Moments::v1, sums.v_powers, 1);
  set(&Moments::v2, sums.v_powers, 2);
  set(&Moments::v4, sums.v_powers, 4);
  snapshot.y = make_marginal(sums.y, request.y_edges, paths, error.y_l1);
  snapshot.ydot = make_marginal(sums.v, request.v_edges, paths, error.ydot_l1);
  return snapshot;
}

// Adds the errors by the interval between noise kicks to the sampling errors.
// @param doubled snapshots with twice the interval
// @param first index of the first snapshot that depends on the interval
// @param order order of the errors in the interval
void add_kick_interval_errors_of_snapshots(
    const std::vector<transform::TransientDensitySnapshot>& doubled, std::size_t first, int order,
    std::vector<transform::TransientDensitySnapshot>& snapshots) {
  // L1 distance of two simulations, in expected L1 distances by sampling errors, up to which
  // sampling errors may explain the distance
  constexpr double kLargestByChance = 1.5;
  for (std::size_t k = first; k < snapshots.size(); ++k) {
    transform::TransientDensitySnapshot& at = snapshots[k];
    const transform::TransientDensitySnapshot& other = doubled[k];
    transform::ErrorEstimate& error = *at.error;
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      error.moments.*moment += kick_interval_error(
          other.moments.*moment - at.moments.*moment,
          std::hypot(error.moments.*moment, other.error->moments.*moment), order);
    }
    const auto add = [&](transform::Marginal transform::TransientDensitySnapshot::*marginal,
                         double transform::ErrorEstimate::*l1) {
      const double by_chance = std::hypot(error.*l1, (*other.error).*l1);
      error.*l1 += kick_interval_l1_error(transform::l1_distance(at.*marginal, other.*marginal),
                                          by_chance, kLargestByChance * by_chance, order);
    };
    add(&transform::TransientDensitySnapshot::y, &transform::ErrorEstimate::y_l1);
    add(&transform::TransientDensitySnapshot::ydot, &transform::ErrorEstimate::ydot_l1);
  }
}

// Numbers of periods of the excitation that are simulated without recording the states.
struct SkippedExcitationPeriods {
  static constexpr double kMostPeriods = 1e6;
  int before_first = 0;  // before the first recorded period, until the initial density has decayed
  int between = 0;  // between two recorded periods, so that their states are nearly independent

  SkippedExcitationPeriods(const SimulationPlan& plan, double decay_rate, double period) {
    constexpr double kDecayTimesBetween = 3;  // a correlation of exp(-3) = 0.05
    const auto periods = [&](double time) {
      return static_cast<int>(std::min(kMostPeriods, std::ceil(time / period)));
    };
    before_first = periods(plan.burn_in);
    between = periods(kDecayTimesBetween / decay_rate);
  }
};

// Simulates kStreams paths in each repetition, and returns the sums over all paths at each time. If
// the density over time is periodic, each repetition continues the paths of the previous
// repetition.
std::vector<SnapshotHistograms> simulate_paths(Simulation& simulation,
                                               InitialStateGenerator& initial, int repetitions,
                                               const SkippedExcitationPeriods& periods,
                                               const TransientRequest& request,
                                               const problem::WallFrame& frame,
                                               const SimulationOptions& options) {
  constexpr std::size_t kParts = 16;  // parts whose sums are added in a fixed order
  const BinFinder y_bins(request.y_edges), v_bins(request.v_edges);
  const auto times = static_cast<std::size_t>(request.snapshots) + 1;
  std::vector<std::vector<SnapshotHistograms>> sums(
      kParts, std::vector<SnapshotHistograms>(times, SnapshotHistograms(y_bins, v_bins)));
  const auto record = [&](std::size_t time) {
    base::parallel_for(kParts, simulation.plan_of_simulation().threads, [&](std::size_t part) {
      for (std::size_t s = part; s < kStreams; s += kParts) {
        const TrajectoryBranch& state = simulation.trajectory_streams()[s].branch;
        sums[part][time].add_path(y_bins, v_bins, frame.physical_y(state.y),
                                  frame.physical_velocity(state.v));
      }
    });
  };
  const auto restart_all = [&] {
    for (std::size_t s = 0; s < kStreams; ++s) {
      const OscillatorState start = initial.draw_state(s);
      simulation.restart_trajectory_stream(s, start.y, start.v);
    }
  };
  const auto skip = [&](int count) {
    for (int k = 0; k < count; ++k) simulation.advance_streams_between_times(0, request.until);
  };
  if (request.periodic) {
    restart_all();
    skip(periods.before_first);
  }
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    if (request.periodic) {
      skip(periods.between);
    } else {
      restart_all();
    }
    record(0);
    for (std::size_t k = 1; k < times; ++k) {
      const int snapshot = static_cast<int>(k);
      simulation.advance_streams_between_times(request.time_of_snapshot(snapshot - 1),
                                               request.time_of_snapshot(snapshot));
      record(k);
    }
    if (options.progress) {
      options.progress({static_cast<double>(repetition + 1) / repetitions});
    }
  }
  std::vector<SnapshotHistograms> all = sums[0];
  for (std::size_t part = 1; part < kParts; ++part) {
    for (std::size_t k = 0; k < times; ++k) all[k].add_sums(sums[part][k]);
  }
  return all;
}

}  // namespace

transform::TransientDensities estimate_transient(const problem::Problem& problem,
                                                 const SimulationOptions& options,
                                                 const TransientRequest& request) {
  const base::Stopwatch stopwatch;
  transform::TransientDensities transient{.id = solution_id(options)};
  transient.has_standard_errors = true;
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system),
                                   problem::with_largest_excitation(problem, request.time_span()));
  const problem::MotionScales scales = problem::motion_scales(transformed);
  const problem::InitialGaussian density =
      problem::initial_density(transformed, scales, request.start);
  transient.reason = unsupported_functional_reason(transformed, options);
  if (!transient.reason.empty()) {
    transient.status = Status::not_offered;
    return transient;
  }
  SimulationOptions many_streams = options;
  many_streams.streams = kStreams;
  SimulationPlan plan = make_simulation_plan(transformed, many_streams);
  plan.sampling_interval = 4 * request.until;  // no path ends its flights at samples
  const SkippedExcitationPeriods periods(plan, scales.slowest_decay_rate, request.until);
  const double time_per_path =
      request.periodic ? (1.0 + periods.between) * request.until : request.until;
  const double events =
      plan.oscillator.is_duffing_at_wall() ? kMostDuffingEvents : kMostOtherEvents;
  const double time =
      options.time.value_or(std::min(kPaths * time_per_path, events / plan.expected_event_rate));
  constexpr double kMostPaths = 1e9;
  if (time / time_per_path > kMostPaths) {
    throw InputError(
        fmt::format("--time {:g}: more than {:g} paths of the duration {:g}; reduce it", time,
                    kMostPaths, time_per_path));
  }
  const int repetitions =
      static_cast<int>(std::ceil(std::max(kFewestPaths, time / time_per_path) / kStreams));
  const double paths = static_cast<double>(repetitions) * kStreams;
  const auto estimate_snapshots = [&](const SimulationPlan& with_interval, int repeated) {
    Simulation simulation(transformed, with_interval);
    InitialStateGenerator initial(transformed.system, density, with_interval.seed);
    const auto sums =
        simulate_paths(simulation, initial, repeated, periods, request, transformed.frame, options);
    std::vector<transform::TransientDensitySnapshot> snapshots;
    for (int k = 0; k <= request.snapshots; ++k) {
      snapshots.push_back(make_snapshot(sums[static_cast<std::size_t>(k)],
                                        request.time_of_snapshot(k),
                                        static_cast<double>(repeated) * kStreams, request));
    }
    return snapshots;
  };
  transient.snapshots = estimate_snapshots(plan, repetitions);
  transient.details = fmt::format("{:.0f} paths", paths);
  if (const auto doubled = plan_with_doubled_kick_interval(transformed, plan)) {
    add_kick_interval_errors_of_snapshots(estimate_snapshots(*doubled, (repetitions + 1) / 2),
                                          request.periodic ? 0 : 1, order_in_kick_interval(plan),
                                          transient.snapshots);
    transient.details += ", errors with that of the interval between noise kicks";
  }
  transient.status = Status::ok;
  if (request.periodic) {
    transient.reason = periods.before_first >= SkippedExcitationPeriods::kMostPeriods
                           ? "the burn-in takes too many periods; give several periods as --until"
                           : short_burn_in_reason(plan, options);
  }
  if (!transient.reason.empty()) transient.status = Status::inaccurate;
  transient.seconds = stopwatch.seconds();
  return transient;
}

}  // namespace fpkcheck::mcs
