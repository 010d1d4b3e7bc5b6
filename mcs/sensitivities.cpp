#include "mcs/sensitivities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/process/stopwatch.hpp"
#include "mcs/applicability.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation/simulation_plan.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::kDifferentiatedMoments;
using transform::Status;

// Simulated time of each changed problem, as a fraction of the default simulated time, and largest
// number of impulses, kicks and flights in all problems, with DuffingFlights and with other
// flights, for about 10 s of computing
constexpr double kTimeShare = 1.0 / 16, kMostDuffingChanges = 1e8, kMostOtherChanges = 4e7;

// Simulates a problem and returns the moments kDifferentiatedMoments of each trajectory stream.
std::vector<std::vector<double>> simulate_stream_moments(const problem::Problem& problem,
                                                         const SimulationOptions& options,
                                                         const SimulationPlan& nominal) {
  // The changed problem has the sampling times and the durations of the original problem, so that
  // the differences between corresponding trajectory streams contain only the effect of the
  // parameter.
  SimulationPlan plan = make_simulation_plan(problem, options);
  plan.burn_in = nominal.burn_in;
  plan.sampling_interval = nominal.sampling_interval;
  plan.samples_per_round = nominal.samples_per_round;
  plan.rounds = nominal.rounds;
  Simulation simulation(problem, plan);
  simulation.run_burn_in();
  for (std::uint64_t round = 0; round < plan.rounds; ++round)
    simulation.simulate_and_sample_one_round();
  std::vector<std::vector<double>> moments;
  for (const auto& moment : kDifferentiatedMoments) {
    moments.push_back(moment_per_stream(simulation, moment.p, moment.q));
  }
  return moments;
}

}  // namespace

transform::MomentSensitivities estimate_sensitivities(
    const problem::Problem& problem, const SimulationOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters) {
  const base::Stopwatch stopwatch;
  transform::MomentSensitivities result{.id = solution_id(options)};
  result.has_standard_errors = true;
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  result.reason = unsupported_functional_reason(transformed, options);
  if (!result.reason.empty()) {
    result.status = Status::not_offered;
    return result;
  }
  SimulationOptions nominal_options = options;
  SimulationPlan nominal = make_simulation_plan(transformed, nominal_options);
  if (!options.time) {
    const double automatic = kTimeShare * static_cast<double>(nominal.rounds) *
                             nominal.simulated_time_per_round() * nominal.streams;
    std::size_t problems = 1;
    for (const auto& parameter : parameters) problems += parameter.terms.size();
    const double events =
        nominal.oscillator.is_duffing_at_wall() ? kMostDuffingChanges : kMostOtherChanges;
    nominal_options.time =
        std::min(automatic, events / nominal.expected_event_rate / static_cast<double>(problems));
    nominal = make_simulation_plan(transformed, nominal_options);
  }

  for (const auto& moment : kDifferentiatedMoments)
    result.expectations.push_back({.expectation = moment.symbol});
  const auto central = simulate_stream_moments(transformed, nominal_options, nominal);
  for (std::size_t m = 0; m < central.size(); ++m) {
    result.expectations[m].value = estimate_unweighted_mean(central[m]).mean;
  }
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto& [parameter, value, terms] = parameters[k];
    result.parameters.push_back(parameter);
    result.parameter_values.push_back(value);
    std::vector<std::vector<double>> quotients(
        std::size(kDifferentiatedMoments),
        std::vector<double>(static_cast<std::size_t>(nominal.streams)));
    for (const auto& [weight, changed] : terms) {
      const problem::Problem other = problem::to_wall_coordinates(transformed.frame, changed);
      const auto moments = simulate_stream_moments(other, nominal_options, nominal);
      for (std::size_t m = 0; m < moments.size(); ++m) {
        for (std::size_t s = 0; s < moments[m].size(); ++s) {
          quotients[m][s] += weight * moments[m][s];
        }
      }
    }
    for (std::size_t m = 0; m < quotients.size(); ++m) {
      const MeanEstimate estimate = estimate_unweighted_mean(quotients[m]);
      result.expectations[m].derivatives.push_back(estimate.mean);
      result.expectations[m].errors.push_back(estimate.standard_error);
    }
    if (options.progress) {
      options.progress({static_cast<double>(k + 1) / static_cast<double>(parameters.size())});
    }
  }
  result.details = fmt::format(
      "simulated time {:.2g} for each changed problem",
      static_cast<double>(nominal.rounds) * nominal.simulated_time_per_round() * nominal.streams);
  result.reason = short_burn_in_reason(nominal, options);
  result.status = result.reason.empty() ? Status::ok : Status::not_converged;
  result.seconds = stopwatch.seconds();
  return result;
}

}  // namespace fpkcheck::mcs
