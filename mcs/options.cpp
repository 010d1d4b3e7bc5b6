#include "mcs/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/input_error.hpp"
#include "mcs/streams/histogram.hpp"

namespace fpkcheck::mcs {

using namespace base;

namespace {

constexpr int kFewestStreams = 8;
constexpr int kMostStreams = 4096;
constexpr int kMostThreads = 1024;
// Largest time step in radians at which the series of order TaylorFlight::kOrder is accurate
constexpr double kLongestStep = 1.2;
constexpr double kLongestWhiteStep = 0.5;
constexpr double kShortestStep = 1e-4;

constexpr DensityEquation kEquations[] = {DensityEquation::kf, DensityEquation::white};

std::vector<std::string> supported_equation_names() {
  std::vector<std::string> list;
  for (const DensityEquation equation : kEquations) list.emplace_back(name(equation));
  return list;
}

}  // namespace

const OptionsDescription<SimulationOptions>& solver_option_descriptions() {
  static const auto description =
      OptionsDescription<SimulationOptions>("mcs.")
          .add("equation", &SimulationOptions::equation,
               {"E",
                "excitation: kf, the impulses; white, Gaussian white noise of the same "
                "intensity"})
          .with_choices(supported_equation_names())
          .add("time", &SimulationOptions::time,
               {"T",
                "simulated time over all streams (default: 1.6e6 decay times, a 32nd of them with "
                "--controlled or --tails, or about a minute)"},
               positive_numbers())
          .add("samples", &SimulationOptions::samples,
               {"N", "simulate until E[y'^2] is as precise as from N independent samples"},
               positive_numbers())
          .add("target_error", &SimulationOptions::target_error,
               {"E",
                "simulate until the relative standard errors of E[y^2] and E[y'^2] and the "
                "expected L1 sampling errors of the densities are below E"},
               open_interval(0, 1))
          .add("accuracy", &SimulationOptions::accuracy,
               {"L1",
                "tolerance for the 99 % quantiles of the L1 sampling errors of p(y) and p(y')"},
               positive_numbers().with_reason_in_message("no simulation is exact"))
          .with_default(SimulationOptions{}.accuracy)
          .add("seed", &SimulationOptions::seed,
               {"S",
                "seed of the random numbers; a seed gives the same result for any number of "
                "threads"},
               non_negative_numbers())
          .add("threads", &SimulationOptions::threads,
               {"N", "threads to use (default: one per processor)"},
               closed_interval(1, kMostThreads))
          .add("streams", &SimulationOptions::streams, {"N", "number of independent streams"},
               closed_interval(kFewestStreams, kMostStreams)
                   .with_reason_in_message(
                       "standard errors come from the differences between streams"))
          .add("step", &SimulationOptions::step,
               {"RAD", "longest Taylor step, in radians of the highest frequency (default 0.9)"},
               closed_interval(kShortestStep, kLongestStep))
          .add(
              "white_step", &SimulationOptions::white_step,
              {"RAD",
               "interval between the kicks that approximate white noise, in radians (default "
               "0.05; for other oscillators than the paper's 0.2 if every restitution coefficient is at "
               "least 0.6, noise.factor is absent and the force does not jump in v)"},
              closed_interval(kShortestStep, kLongestWhiteStep))
          .add("tails", &SimulationOptions::tails,
               {"", "resolve the far tails by importance splitting"})
          .add("controlled", &SimulationOptions::controlled,
               {"",
                "reduce the variance by control variates, as `run` does: moments to about 1e-9, "
                "densities in smooth bins to 1e-6"})
          .with_default(false);
  return description;
}

void validate(const SimulationOptions& options) {
  solver_option_descriptions().validate(options);
  if (std::ranges::find(kEquations, options.equation) == std::end(kEquations)) {
    throw InputError(
        fmt::format("mcs.equation = {}: not supported by the simulation; use kf (impulses) or "
                    "white (Gaussian white noise)",
                    name(options.equation)));
  }
  if (!options.y_edges.empty()) require_increasing_edges("mcs.y_edges", options.y_edges);
  if (!options.v_edges.empty()) require_increasing_edges("mcs.v_edges", options.v_edges);
  if (options.deposit) require_valid_deposit_grid(*options.deposit);
  if (options.deposit && (options.equation != DensityEquation::kf || options.tails)) {
    throw InputError(
        "mcs.deposit with white noise or tails: deposits need impulses without "
        "splitting; omit mcs.deposit");
  }
  if (!options.y_edges.empty() && options.y_edges.front() != 0) {
    throw InputError(fmt::format("mcs.y_edges from {}: the wall is at y = 0; start the edges at 0",
                                 options.y_edges.front()));
  }
}

std::string solution_id(const SimulationOptions& options) {
  return options.equation == DensityEquation::white ? "mcs-white" : "mcs";
}

transform::SolutionIdentity solution_identity(const SimulationOptions& options) {
  return {.id = solution_id(options),
          .method = "mcs",
          .equation = options.equation,
          .impact = problem::ImpactCondition::exact,
          .role = transform::SolutionRole::simulation};
}

std::optional<SimulationOptions> options_of(std::string_view id) {
  for (const DensityEquation equation : kEquations) {
    const SimulationOptions options{.equation = equation};
    if (mcs::solution_id(options) == id) return options;
  }
  return std::nullopt;
}

}  // namespace fpkcheck::mcs
