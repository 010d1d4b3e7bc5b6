#include "mcs/go_on.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"

namespace fpkcheck::mcs {
namespace {

/// Options::target_error, as far as it has come.
double current_error(const Simulation& simulation) {
  const StreamWeights weights(excess_powers(simulation));
  double error = 0;
  for (const auto& [p, q] : {std::pair{2, 0}, std::pair{0, 2}}) {
    const Estimate e = weights.estimate(moments(simulation, p, q));
    error = std::max(error, e.standard_error / e.mean);
  }
  for (const auto variable : transform::kVariables) {
    error =
        std::max(error, expected_l1(estimate_marginal(simulation, weights, variable, 1).errors));
  }
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

/// How far a simulation has come.
struct Reached {
  double fraction;  ///< of the way; may be more than 1
  double error;     ///< 0 where nobody asks
  bool goal;        ///< the samples and the error that were asked for
};

Reached reached(const Simulation& simulation, const Options& options) {
  Reached now{.fraction = static_cast<double>(simulation.rounds()) /
                          static_cast<double>(simulation.plan().rounds),
              .error = 0,
              .goal = false};
  if (simulation.rounds() == 0) return now;
  now.goal = options.target_error || options.samples;
  // What is known here alone tells no error.
  if (options.team.parts > 1) return now;
  if (options.target_error || options.progress) now.error = current_error(simulation);
  if (options.target_error) {
    now.fraction = std::max(now.fraction, std::pow(*options.target_error / now.error, 2));
    now.goal = now.goal && now.error <= *options.target_error;
  }
  if (options.samples) {
    const double samples = effective_samples(simulation, 0, 2);
    now.fraction = std::max(now.fraction, samples / *options.samples);
    now.goal = now.goal && samples >= *options.samples;
  }
  return now;
}

/// The ending that the simulation has come to; nothing as long as it goes on.
std::optional<Ending> ending(const Simulation& simulation, const Options& options,
                             const Reached& now) {
  if (now.goal) return Ending{};
  if (simulation.rounds() >= simulation.plan().rounds) {
    if (!options.target_error && !options.samples) return Ending{};
    return Ending{
        .unreached = "the time ended before the samples or the error asked for (give more --time)"};
  }
  // The parts of a team are of one length: told to stop, the process is ended.
  if (simulation.rounds() > 0 && options.team.parts == 1 && options.stop && options.stop()) {
    return Ending{.unreached = fmt::format("interrupted after {:.1f} % of what was asked for",
                                           100 * std::min(now.fraction, 1.0)),
                  .interrupted = true};
  }
  return std::nullopt;
}

}  // namespace

Ending go_on(Simulation& simulation, const Options& options, CheckpointWriter& checkpoints,
             const std::string& fingerprint) {
  checkpoints.write(fingerprint, simulation);
  for (bool first = true;; first = false) {
    const Reached now = reached(simulation, options);
    if (options.progress && !first) {
      options.progress({.fraction = std::min(now.fraction, 1.0), .error = now.error});
    }
    if (auto end = ending(simulation, options, now)) {
      checkpoints.write_last(fingerprint, simulation);
      return *std::move(end);
    }
    simulation.round();
    checkpoints.write_when_due(fingerprint, simulation);
  }
}

}  // namespace fpkcheck::mcs
