#include "mcs/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "mcs/checkpoint.hpp"
#include "mcs/crossings.hpp"
#include "mcs/density_estimate.hpp"
#include "mcs/plan.hpp"
#include "mcs/quantiles.hpp"
#include "mcs/simulation.hpp"
#include "mcs/stream_weights.hpp"
#include "mcs/tails.hpp"
#include "problem/energy_balance.hpp"

namespace fpkcheck::mcs {
namespace {

using Clock = std::chrono::steady_clock;

/// The mean of y^p y'^q in a stream.
double moment(const Simulation& simulation, const StreamRecord& record, int p, int q) {
  const auto place = std::ranges::find(kPowers, std::pair{p, q}) - kPowers.begin();
  return record.powers[static_cast<std::size_t>(place)] / simulation.stream_samples();
}

std::vector<double> moments(const Simulation& simulation, int p, int q) {
  return each(simulation.streams(),
              [&](const StreamRecord& record) { return moment(simulation, record, p, q); });
}

/// Power that the impulses of each stream happened to bring beyond its expectation.
std::vector<double> excess_powers(const Simulation& simulation) {
  // Impulses come independently of the motion before them, so that their work, Excitation::work,
  // has the expectation lambda int (E[Y] E[v] + E[Y^2]/2) dt; and E[v] = 0, since int v dt is the
  // change of y, which impacts leave alone.
  const double expected = simulation.plan().excitation.work;
  return each(simulation.streams(), [&](const StreamRecord& record) {
    return record.work / simulation.stream_time() - expected;
  });
}

double square(double x) { return x * x; }

/// Var(x) / SE^2 of x = y^p y'^q: how many independent draws tell as much of its mean.
double effective_samples(const Simulation& simulation, int p, int q) {
  const auto [mean, error] = plain_estimate(moments(simulation, p, q));
  const double second = plain_estimate(moments(simulation, 2 * p, 2 * q)).mean;
  return (second - mean * mean) / square(error);
}

/// Options::target_error, as far as it has come.
double current_error(const Simulation& simulation) {
  const StreamWeights weights(excess_powers(simulation));
  double error = 0;
  for (const auto& [p, q] : {std::pair{2, 0}, std::pair{0, 2}}) {
    const Estimate e = weights.estimate(moments(simulation, p, q));
    error = std::max(error, e.standard_error / e.mean);
  }
  for (const auto variable : {transform::Variable::y, transform::Variable::ydot}) {
    error =
        std::max(error, expected_l1(estimate_marginal(simulation, weights, variable, 1).errors));
  }
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

/// Goes on until what was asked for is reached.
/// @return why it was not, in one sentence; empty when it was
std::string run(Simulation& simulation, const std::string& fingerprint, const Options& options,
                bool& interrupted) {
  constexpr std::chrono::seconds kBetweenCheckpoints(30);
  auto written = Clock::now();
  const Plan& plan = simulation.plan();
  const bool asks_for_error = options.target_error > 0;
  const bool asks_for_samples = options.samples > 0;
  if (!options.checkpoint.empty()) write_checkpoint(options.checkpoint, fingerprint, simulation);
  std::string unreached;
  for (bool first = true;; first = false) {
    double fraction = static_cast<double>(simulation.rounds()) / static_cast<double>(plan.rounds);
    if (simulation.rounds() > 0) {
      const double error = asks_for_error || options.progress ? current_error(simulation) : 0;
      const double samples = asks_for_samples ? effective_samples(simulation, 0, 2) : 0;
      if (asks_for_error) fraction = std::max(fraction, square(options.target_error / error));
      if (asks_for_samples) fraction = std::max(fraction, samples / options.samples);
      const bool reached = (asks_for_error || asks_for_samples) &&
                           (!asks_for_error || error <= options.target_error) &&
                           (!asks_for_samples || samples >= options.samples);
      if (options.progress && !first) {
        options.progress({.fraction = std::min(fraction, 1.0), .error = error});
      }
      if (reached) break;
    }
    if (simulation.rounds() >= plan.rounds) {
      if (asks_for_error || asks_for_samples) {
        unreached = "the time ended before the samples or the error asked for (give more --time)";
      }
      break;
    }
    if (simulation.rounds() > 0 && options.stop && options.stop()) {
      interrupted = true;
      unreached = fmt::format("interrupted after {:.1f} % of what was asked for",
                              100 * std::min(fraction, 1.0));
      break;
    }
    simulation.round();
    if (!options.checkpoint.empty() && Clock::now() - written > kBetweenCheckpoints) {
      write_checkpoint(options.checkpoint, fingerprint, simulation);
      written = Clock::now();
    }
  }
  if (!options.checkpoint.empty()) write_checkpoint(options.checkpoint, fingerprint, simulation);
  return unreached;
}

void estimate_moments(const Simulation& simulation, const StreamWeights& weights, Result& result) {
  using transform::Moments;
  auto& [solution, summary] = result;
  for (const auto& [p, q] : kPowers) {
    summary.joint_moments.push_back(weights.estimate(moments(simulation, p, q)));
  }
  const auto set = [&](double Moments::*member, int p, int q) {
    const Estimate e = weights.estimate(moments(simulation, p, q));
    solution.moments.*member = e.mean;
    summary.standard_errors.moments.*member = e.standard_error;
  };
  set(&Moments::y1, 1, 0);
  set(&Moments::y2, 2, 0);
  set(&Moments::y4, 4, 0);
  set(&Moments::v1, 0, 1);
  set(&Moments::v2, 0, 2);
  set(&Moments::v4, 0, 4);
}

void estimate_impacts(const problem::Problem& problem, const Simulation& simulation,
                      const StreamWeights& weights, Result& result) {
  result.summary.impact_rate = weights.estimate(each(
      simulation.streams(), [&](const auto& r) { return r.impacts / simulation.stream_time(); }));
  // Linear in the averages: the average of the streams' own residuals.
  const auto residual = weights.estimate(each(simulation.streams(), [&](const auto& r) {
    return problem::energy_residual(
        problem, problem::Impact::exact,
        {.mean_velocity = moment(simulation, r, 0, 1),
         .mean_square_velocity = moment(simulation, r, 0, 2),
         .impact_energy_flux = r.impact_energy / simulation.stream_time()});
  }));
  result.solution.energy_residual = residual.mean;
  result.summary.standard_errors.energy_residual = residual.standard_error;
}

/// Whether the impulses followed their law, before the weights set it right.
void estimate_excess_power(const Simulation& simulation, Summary& summary) {
  const auto excess = plain_estimate(excess_powers(simulation));
  const double input = simulation.plan().excitation.power;
  summary.excess_power = excess.mean / input;
  summary.excess_power_error = excess.standard_error / input;
}

/// What the samples are worth without the weights, and what the weights add.
void estimate_efficiency(const Simulation& simulation, Summary& summary) {
  const auto reduction = [&](int p, int q, double error) {
    return square(plain_estimate(moments(simulation, p, q)).standard_error / error);
  };
  const auto& errors = summary.standard_errors.moments;
  summary.effective_samples = effective_samples(simulation, 0, 2);
  summary.effective_samples_y2 = effective_samples(simulation, 2, 0);
  summary.variance_reduction_y2 = reduction(2, 0, errors.y2);
  summary.variance_reduction_v2 = reduction(0, 2, errors.v2);
}

/// Share of the samples beyond the bins.
double outside(const Simulation& simulation, const StreamWeights& weights) {
  const Plan& plan = simulation.plan();
  const auto beyond = each(simulation.streams(), [&](const StreamRecord& record) {
    const auto rows = record.histogram.row_sums();
    const double all = std::accumulate(rows.begin(), rows.end(), 0.0);
    double inside = 0;
    for (std::size_t i = 1; i <= plan.y_bins.bins(); ++i) {
      for (std::size_t j = 1; j <= plan.v_bins.bins(); ++j) inside += record.histogram(i, j);
    }
    return all > 0 ? (all - inside) / all : 0.0;
  });
  return std::max(0.0, weights.estimate(beyond).mean);
}

void estimate_densities(const Simulation& simulation, const StreamWeights& weights,
                        Result& result) {
  auto& [solution, summary] = result;
  const auto marginal = [&](transform::Variable variable) {
    auto estimate = estimate_marginal(simulation, weights, variable, summary.effective_samples);
    solution.estimated_marginals.emplace_back(variable, std::move(estimate.marginal));
    return sampling_l1(estimate.errors);
  };
  const SamplingL1 y = marginal(transform::Variable::y);
  const SamplingL1 ydot = marginal(transform::Variable::ydot);
  summary.sampling_l1_y = y.expected;
  summary.sampling_l1_ydot = ydot.expected;
  summary.sampling_l1_y_99 = y.in_99;
  summary.sampling_l1_ydot_99 = ydot.in_99;
  auto joint = estimate_joint_density(simulation, weights);
  solution.mass = transform::mass(joint.density);
  solution.density = std::move(joint.density);
  summary.joint_standard_errors = std::move(joint.standard_errors);
  summary.outside = outside(simulation, weights);
  summary.y_quantiles = estimate_quantiles(simulation, weights, transform::Variable::y);
  summary.v_quantiles = estimate_quantiles(simulation, weights, transform::Variable::ydot);
  summary.crossings = estimate_crossings(simulation, weights);
  summary.peaks = estimate_peaks(simulation, weights);
}

void describe(const Simulation& simulation, Summary& summary) {
  const Plan& plan = simulation.plan();
  summary.time = simulation.stream_time() * plan.streams;
  summary.samples =
      simulation.rounds() * plan.samples_per_round * static_cast<std::uint64_t>(plan.streams);
  summary.sampling_interval = plan.sampling_interval;
  summary.seed = plan.seed;
  summary.threads = plan.threads;
  summary.streams = plan.streams;
  summary.step = plan.step;
  if (plan.excitation.arrivals == Excitation::Arrivals::even) {
    summary.kick_interval = plan.excitation.interval;
  }
  summary.burn_in = plan.burn_in;
  summary.rounds = simulation.rounds();
  for (const Stream& stream : simulation.streams()) {
    summary.impulses += stream.record.impulses;
    summary.flights += stream.record.flights;
  }
}

void judge(const Summary& summary, transform::Solution& solution, const std::string& unreached) {
  constexpr std::uint64_t kFewestImpulses = 10;  // of a stream
  const transform::Moments& m = solution.moments;
  const bool finite = std::isfinite(m.y1 + m.y2 + m.y4 + m.v1 + m.v2 + m.v4);
  solution.status = unreached.empty() ? transform::Status::ok : transform::Status::not_converged;
  solution.reason = unreached;
  const auto streams = static_cast<std::uint64_t>(summary.streams);
  if (summary.impulses < kFewestImpulses * streams) {
    solution.status = transform::Status::not_converged;
    solution.reason = fmt::format(
        "only {} impulses came in {} streams (errors cannot be told from so few) give more --time",
        summary.impulses, summary.streams);
  }
  if (!finite || !(solution.mass > 0)) {
    solution.status = transform::Status::failed;
    solution.reason =
        "the trajectories left the range of numbers, or the histogram altogether (is the problem "
        "scaled sensibly?)";
  }
}

}  // namespace

std::string id(const Options& options) {
  return options.equation == Equation::white ? "mcs-white" : "mcs";
}

Result simulate(const problem::Problem& problem, const Options& options) {
  const auto begin = Clock::now();
  const Plan plan = make_plan(problem, options);
  std::optional<Splitting> splitting;
  if (options.tails) splitting = plan_splitting(problem, plan);
  Simulation simulation(problem, plan, splitting ? &*splitting : nullptr);
  const std::string identity = fingerprint(problem, plan, splitting ? &*splitting : nullptr);
  if (options.resume.empty()) {
    simulation.burn_in();
  } else {
    read_checkpoint(options.resume, identity, simulation);
  }
  Result result;
  std::string unreached = run(simulation, identity, options, result.summary.interrupted);

  const StreamWeights weights(excess_powers(simulation));
  transform::Solution& solution = result.solution;
  solution.method = "mcs";
  solution.equation = options.equation == Equation::white ? "white" : "kf";
  solution.id = id(options);
  solution.impact = problem::Impact::exact;
  estimate_moments(simulation, weights, result);
  estimate_impacts(problem, simulation, weights, result);
  estimate_excess_power(simulation, result.summary);
  estimate_efficiency(simulation, result.summary);
  estimate_densities(simulation, weights, result);
  describe(simulation, result.summary);
  if (splitting) {
    result.summary.thresholds = splitting->thresholds();
    if (result.summary.thresholds.empty() && unreached.empty()) {
      unreached =
          "no energies were found at which to split, too few impulses in the pilot runs (simulate "
          "without --tails, or with more --streams)";
    }
  }
  judge(result.summary, solution, unreached);
  solution.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return result;
}

}  // namespace fpkcheck::mcs
