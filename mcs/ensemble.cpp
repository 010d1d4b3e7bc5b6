#include "mcs/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "mcs/histogram.hpp"
#include "mcs/impulse_source.hpp"
#include "mcs/trajectory.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr double kStep = 0.9;  // radians, as in simulate()
// Sums are made within shares of the ensemble and then over the shares in their order, so that
// nothing depends on the number of threads.
constexpr std::uint32_t kShares = 64;

constexpr double transform::Moments::*kMoments[] = {
    &transform::Moments::y1, &transform::Moments::y2, &transform::Moments::y4,
    &transform::Moments::v1, &transform::Moments::v2, &transform::Moments::v4};

// The bins of a variable; none where it has no edges.
using Bins = std::optional<BinFinder>;

/// What a share of the ensemble saw at one time.
struct Sums {
  transform::Moments first{}, second{};  // sums of the powers, and of their squares
  std::vector<std::uint64_t> y{}, v{};   // counts, with one bin more on either side

  Sums(const Bins& y_bins, const Bins& v_bins)
      : y(y_bins ? y_bins->bins() + 2 : 0), v(v_bins ? v_bins->bins() + 2 : 0) {}

  void add(const State& state, const Bins& y_bins, const Bins& v_bins) {
    const double y2 = state.y * state.y, v2 = state.v * state.v;
    const transform::Moments powers{state.y, y2, y2 * y2, state.v, v2, v2 * v2};
    for (const auto moment : kMoments) {
      first.*moment += powers.*moment;
      second.*moment += powers.*moment * powers.*moment;
    }
    if (y_bins) ++y[(*y_bins)(state.y)];
    if (v_bins) ++v[(*v_bins)(state.v)];
  }

  void add(const Sums& other) {
    for (const auto moment : kMoments) {
      first.*moment += other.first.*moment;
      second.*moment += other.second.*moment;
    }
    std::ranges::transform(y, other.y, y.begin(), std::plus{});
    std::ranges::transform(v, other.v, v.begin(), std::plus{});
  }
};

/// The Gaussian of (z, z') folded by paper (5): y = |z|, y' = z' sgn z.
State folded_start(const EnsembleOptions& options, const ImpulseSource& source) {
  const auto normals = source.standard_normals();
  const double z = options.start_displacement * normals[0];
  const double z_dot = options.start_velocity * normals[1];
  return {std::abs(z), std::copysign(1.0, z) * z_dot};
}

std::vector<Sums> run_share(const problem::Problem& problem, const EnsembleOptions& options,
                            const Bins& y_bins, const Bins& v_bins, std::uint32_t share) {
  std::vector<Sums> sums(options.times.size(), Sums(y_bins, v_bins));
  for (std::uint32_t n = share; n < options.trajectories; n += kShares) {
    ImpulseSource source(problem.impulses, options.seed, n);
    const State start = folded_start(options, source);
    Trajectory trajectory(problem.system, source, start, kStep);
    NoWitness no_witness;
    double time = 0;
    for (std::size_t k = 0; k < options.times.size(); ++k) {
      trajectory.advance(options.times[k] - time, no_witness);
      time = options.times[k];
      sums[k].add(trajectory.state(), y_bins, v_bins);
    }
  }
  return sums;
}

std::vector<std::vector<Sums>> run_shares(const problem::Problem& problem,
                                          const EnsembleOptions& options, const Bins& y_bins,
                                          const Bins& v_bins) {
  std::vector<std::vector<Sums>> shares(kShares);
  std::atomic<std::uint32_t> next = 0;
  std::mutex mutex;  // guards the failure
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::uint32_t s = next++; s < kShares; s = next++) {
      try {
        shares[s] = run_share(problem, options, y_bins, v_bins, s);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = kShares;  // nobody begins another share
      }
    }
  };
  {
    const int threads = options.threads > 0
                            ? options.threads
                            : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<std::jthread> others;
    for (int t = 1; t < threads; ++t) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return shares;
}

transform::Marginal marginal(const Bins& bins, const std::vector<std::uint64_t>& counts,
                             double trajectories) {
  constexpr double kNormal95 = 1.959964;
  if (!bins) return {};
  transform::Marginal m{.edges = bins->edges(), .density = {}, .lower = {}, .upper = {}};
  for (std::size_t b = 0; b < bins->bins(); ++b) {
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
  for (const auto moment : kMoments) {
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
  constexpr int kMostThreads = 1024;
  for (const double deviation : {options.start_displacement, options.start_velocity}) {
    require(std::isfinite(deviation) && deviation >= 0,
            fmt::format("deviation {} of the start (must be 0 or a positive number)", deviation));
  }
  require(!options.times.empty() && options.times.front() >= 0 &&
              std::isfinite(options.times.back()) &&
              std::ranges::is_sorted(options.times, std::less_equal<>{}),
          fmt::format("{} times of an ensemble (must be increasing, from 0 or later)",
                      options.times.size()));
  require(options.trajectories >= kFewest,
          fmt::format("{} trajectories (standard errors need at least {})", options.trajectories,
                      kFewest));
  require(options.threads >= 0 && options.threads <= kMostThreads,
          fmt::format("{} threads (must be 1 to {}; use 0 for one per processor)", options.threads,
                      kMostThreads));
  for (const auto* edges : {&options.y_edges, &options.v_edges}) {
    require(edges->empty() ||
                (edges->size() > 1 && std::ranges::is_sorted(*edges, std::less_equal<>{})),
            fmt::format("{} bin edges (must be two or more increasing numbers)", edges->size()));
  }
}

}  // namespace

std::vector<EnsembleSnapshot> simulate_ensemble(const problem::Problem& problem,
                                                const EnsembleOptions& options) {
  validate(options);
  const auto bins = [](const std::vector<double>& edges) {
    return edges.empty() ? Bins() : Bins(edges);
  };
  const Bins y_bins = bins(options.y_edges), v_bins = bins(options.v_edges);
  const auto shares = run_shares(problem, options, y_bins, v_bins);
  std::vector<EnsembleSnapshot> snapshots;
  for (std::size_t k = 0; k < options.times.size(); ++k) {
    Sums sums(y_bins, v_bins);
    for (const auto& share : shares) sums.add(share[k]);
    snapshots.push_back(snapshot(options.times[k], sums, y_bins, v_bins, options.trajectories));
  }
  return snapshots;
}

}  // namespace fpkcheck::mcs
