#include "mcs/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/input_error.hpp"
#include "base/process/parallel_for.hpp"
#include "mcs/estimate/estimate.hpp"
#include "mcs/motion/trajectory.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {
namespace {

// The sums over fixed groups of trajectories are computed first, then added in the order of the
// groups. The floating-point result is therefore independent of the number of threads.
constexpr std::uint32_t kShares = 64;

// The bins of a variable; empty if the options have no edges.
using Bins = std::optional<BinFinder>;

/// Sums over one group of the trajectories at one time.
struct Sums {
  transform::Moments first{}, second{};  // sums of the powers, and of their squares
  std::vector<std::uint64_t> y{}, v{};   // counts in the bins, with two outer bins

  Sums(const Bins& y_bins, const Bins& v_bins)
      : y(y_bins ? y_bins->bin_count() + 2 : 0), v(v_bins ? v_bins->bin_count() + 2 : 0) {}

  void add(const State& state, const Bins& y_bins, const Bins& v_bins) {
    const double y2 = state.y * state.y, v2 = state.v * state.v;
    const transform::Moments powers{state.y, y2, y2 * y2, state.v, v2, v2 * v2};
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      first.*moment += powers.*moment;
      second.*moment += powers.*moment * powers.*moment;
    }
    if (y_bins) ++y[(*y_bins)(state.y)];
    if (v_bins) ++v[(*v_bins)(state.v)];
  }

  void add(const Sums& other) {
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      first.*moment += other.first.*moment;
      second.*moment += other.second.*moment;
    }
    std::ranges::transform(y, other.y, y.begin(), std::plus{});
    std::ranges::transform(v, other.v, v.begin(), std::plus{});
  }
};

std::vector<Sums> run_share(const problem::Problem& problem, const EnsembleOptions& options,
                            const Bins& y_bins, const Bins& v_bins, std::uint32_t share) {
  const Oscillator oscillator(problem.system);
  const Excitation excitation = poisson_excitation(problem.impulses);
  std::vector<Sums> sums(options.times.size(), Sums(y_bins, v_bins));
  for (std::uint32_t n = share; n < options.trajectories; n += kShares) {
    ImpulseSource source(excitation, options.seed, n);
    const State start =
        folded_initial_state(source, options.start_displacement, options.start_velocity);
    Trajectory trajectory(oscillator, source, start, kAutomaticStep);
    NullObserver no_observer;
    double time = 0;
    for (std::size_t k = 0; k < options.times.size(); ++k) {
      trajectory.advance(options.times[k] - time, no_observer);
      time = options.times[k];
      sums[k].add(trajectory.state(), y_bins, v_bins);
    }
  }
  return sums;
}

transform::Marginal marginal(const Bins& bins, const std::vector<std::uint64_t>& counts,
                             double trajectories) {
  if (!bins) return {};
  transform::Marginal m{.edges = bins->edges(), .density = {}, .lower = {}, .upper = {}};
  for (std::size_t b = 0; b < bins->bin_count(); ++b) {
    const double share = static_cast<double>(counts[b + 1]) / trajectories;
    const double width = m.edges[b + 1] - m.edges[b];
    const double half = kNormal95 * std::sqrt(share * (1 - share) / trajectories);
    m.density.push_back(share / width);
    m.lower.push_back(std::max(0.0, share - half) / width);
    m.upper.push_back((share + half) / width);
  }
  return m;
}

EnsembleSnapshot snapshot(double time, const Sums& sums, const Bins& y_bins, const Bins& v_bins,
                          double trajectories) {
  EnsembleSnapshot s{.time = time};
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    const double mean = sums.first.*moment / trajectories;
    const double variance = std::max(0.0, sums.second.*moment / trajectories - mean * mean);
    s.moments.*moment = mean;
    s.standard_errors.*moment = std::sqrt(variance / (trajectories - 1));
  }
  s.y = marginal(y_bins, sums.y, trajectories);
  s.v = marginal(v_bins, sums.v, trajectories);
  return s;
}

void require(bool holds, const std::string& message) {
  if (!holds) throw InputError(message);
}

void validate(const EnsembleOptions& options) {
  constexpr std::uint32_t kFewest = 100;
  for (const double deviation : {options.start_displacement, options.start_velocity}) {
    require(std::isfinite(deviation) && deviation >= 0,
            fmt::format("initial standard deviation {}: out of range; use 0 or a positive number",
                        deviation));
  }
  require(
      !options.times.empty() && options.times.front() >= 0 && std::isfinite(options.times.back()) &&
          std::ranges::adjacent_find(options.times, std::greater_equal<>{}) == options.times.end(),
      fmt::format("{} ensemble times: not increasing from 0 or later; sort the times",
                  options.times.size()));
  require(options.trajectories >= kFewest,
          fmt::format("{} trajectories: too few for standard errors; use at least {}",
                      options.trajectories, kFewest));
  // Simulation and ensemble have these options in common, with the same ranges and messages.
  mcs::validate({.seed = options.seed, .threads = options.threads});
  if (!options.y_edges.empty()) require_edges("y_edges", options.y_edges);
  if (!options.v_edges.empty()) require_edges("v_edges", options.v_edges);
}

}  // namespace

std::vector<EnsembleSnapshot> simulate_ensemble(const problem::Problem& problem,
                                                const EnsembleOptions& options) {
  validate(options);
  const problem::System& system = problem.system;
  require(system.left_wall() && system.left_wall()->position == 0 && !system.right_wall() &&
              system.has_constant_damping() && problem.impulses.is_present() &&
              !problem.noise.is_present(),
          "unsupported ensemble: needs one left wall at y = 0, damping c y' and impulses only; "
          "simulate the stationary law");
  const auto bins = [](const std::vector<double>& edges) {
    return edges.empty() ? Bins() : Bins(edges);
  };
  const Bins y_bins = bins(options.y_edges), v_bins = bins(options.v_edges);
  std::vector<std::vector<Sums>> shares(kShares);
  base::parallel_for(kShares, options.threads.value_or(0), [&](std::size_t s) {
    shares[s] = run_share(problem, options, y_bins, v_bins, static_cast<std::uint32_t>(s));
  });
  std::vector<EnsembleSnapshot> snapshots;
  for (std::size_t k = 0; k < options.times.size(); ++k) {
    Sums sums(y_bins, v_bins);
    for (const auto& share : shares) sums.add(share[k]);
    snapshots.push_back(snapshot(options.times[k], sums, y_bins, v_bins, options.trajectories));
  }
  return snapshots;
}

}  // namespace fpkcheck::mcs
