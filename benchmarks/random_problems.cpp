#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "base/process/parallel_for.hpp"
#include "compare/comparison_bins.hpp"
#include "compare/rest_atoms.hpp"
#include "mcs/applicability.hpp"
#include "mcs/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/method_interface.hpp"
#include "methods/run_cases.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"
#include "random_formula.hpp"
#include "random_oscillator.hpp"
#include "random_problem.hpp"
#include "transform/solution.hpp"

// Random problems over the whole range of accepted parameters, solved with the given methods and
// compared with the simulation. For each method: the number of `ok` solutions, how many of these
// are wrong, and whether errors are below the error estimates.
//
//   fpkcheck_random [--count 200] [--first 0] [--family | --formulas] [--methods fd-kf] [--keep DIR] [--verbose]
//
// With --tails: time and memory of the splitting simulation of each problem, and the lowest density
// that it resolves.
//
//   fpkcheck_random --tails --family --count 40
namespace fpkcheck::benchmarks {
namespace {

using transform::Marginal;
using transform::Solution;
using transform::StateVariable;
using transform::Status;

struct Settings {
  int count = 200;
  int first = 0;
  std::string methods = "fd-kf";
  std::string keep = {};       // directory with stored simulations, to be reused
  std::string numbers = {};    // numbers of the problems, in place of `count` from `first`
  std::string transport = {};  // option of fd; empty for automatic
  bool verbose = false;
  // Limit on the impulses and radians of a simulation: with 1e4 impulses per decay time the full
  // duration would take hours. The many impulses compensate for the shorter duration.
  double events = 4e8;
  double seconds = 3600;  // limit on the time of a simulation; kicks of noise are not counted above
  bool family = false;    // problems of any oscillator, not only of the paper's oscillator
  bool formulas = false;  // oscillators whose force is a formula
  bool tails = false;     // run print_tails only
};

// The results of the simulation of a problem, as reference.
struct SimulationReference {
  Marginal y, ydot;
  double y_sampling_l1, ydot_sampling_l1;  // expected sampling error in L1
  std::vector<transform::RestAtom> atoms = {};
  std::string status = {};  // only an `ok` simulation serves as reference; empty: not simulated

  bool is_simulated() const { return !status.empty(); }
  bool is_usable() const { return status == "ok"; }
};

// The solution of a method, compared with the reference.
struct MethodResult {
  std::string status;
  double seconds = 0;
  bool density = false;
  double y_l1 = 0, ydot_l1 = 0;  // distances from the simulation
  std::optional<transform::ErrorEstimate> error_estimate;
  std::string reason;

  double max_l1() const { return std::max(y_l1, ydot_l1); }
};

mcs::SimulationOptions reference_options(const problem::Problem& problem,
                                         const compare::ComparisonBins& axes,
                                         const Settings& settings) {
  const auto scales = problem::motion_scales(problem);
  const double decay_times = 1.6e6 / scales.slowest_decay_rate;
  const double events = problem.impulses.arrival_rate() + scales.frequency;
  const auto has_ended = [start = std::chrono::steady_clock::now(), limit = settings.seconds] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > limit;
  };
  return {.time = std::min(decay_times, settings.events / events),
          .y_edges = axes.y_edges,
          .v_edges = axes.v_edges,
          .stop = has_ended};
}

void write(std::ostream& out, const Marginal& marginal) {
  for (const double density : marginal.density) out << fmt::format("{:.9g} ", density);
  out << '\n';
}

Marginal read(std::istream& in, const std::vector<double>& edges) {
  Marginal marginal{
      .edges = edges, .density = std::vector<double>(edges.size() - 1), .lower = {}, .upper = {}};
  for (double& density : marginal.density) in >> density;
  return marginal;
}

SimulationReference simulation_reference(const problem::Problem& problem,
                                         const compare::ComparisonBins& axes,
                                         const Settings& settings) {
  const std::filesystem::path stored_file =
      std::filesystem::path(settings.keep) / (problem.name + ".txt");
  if (std::ifstream in(stored_file); !settings.keep.empty() && in) {
    SimulationReference simulation_reference{};
    in >> simulation_reference.status >> simulation_reference.y_sampling_l1 >>
        simulation_reference.ydot_sampling_l1;
    simulation_reference.y = read(in, axes.y_edges);
    simulation_reference.ydot = read(in, axes.v_edges);
    for (transform::RestAtom atom; in >> atom.y >> atom.probability;)
      simulation_reference.atoms.push_back(atom);
    return simulation_reference;
  }
  const auto solution = methods::solve_in_wall_coordinates(
      problem, {axes, {}}, [](const problem::Problem&) { return std::string(); },
      [&](const problem::Problem& transformed,
          const methods::SolverInputContext& transformed_context) {
        return mcs::simulate_stationary_density(
                   transformed, reference_options(transformed, transformed_context.axes, settings))
            .solution;
      });
  if (!solution.sampling)
    throw std::runtime_error(problem.name + " could not be simulated: " + solution.reason);
  SimulationReference simulation_reference{
      .y = transform::marginal(solution, StateVariable::y, axes.y_edges),
      .ydot = transform::marginal(solution, StateVariable::ydot, axes.v_edges),
      .y_sampling_l1 = solution.sampling->y.value_or(0),
      .ydot_sampling_l1 = solution.sampling->ydot.value_or(0),
      .atoms = solution.atoms,
      .status = std::string(name(solution.status))};
  if (!settings.keep.empty()) {
    std::ofstream out(stored_file);
    out << simulation_reference.status << ' ' << simulation_reference.y_sampling_l1 << ' '
        << simulation_reference.ydot_sampling_l1 << '\n';
    write(out, simulation_reference.y);
    write(out, simulation_reference.ydot);
    for (const auto& atom : simulation_reference.atoms) {
      out << fmt::format("{:.17g} {:.9g}\n", atom.y, atom.probability);
    }
  }
  return simulation_reference;
}

MethodResult compare_with_reference(const SimulationReference& simulation_reference,
                                    const Solution& solution) {
  MethodResult result{.status = std::string(name(solution.status)),
                      .seconds = solution.seconds,
                      .density = solution.density.has_value(),
                      .error_estimate = solution.error,
                      .reason = solution.reason};
  if (!result.density || !simulation_reference.is_simulated()) return result;
  const auto distance_to_reference = [&](StateVariable variable, const Marginal& judged) {
    return transform::l1_distance(transform::marginal(solution, variable, judged.edges), judged) +
           compare::rest_atom_l1_distance(solution.atoms, simulation_reference.atoms, variable);
  };
  result.y_l1 = distance_to_reference(StateVariable::y, simulation_reference.y);
  result.ydot_l1 = distance_to_reference(StateVariable::ydot, simulation_reference.ydot);
  return result;
}

void print_parameters(const problem::Problem& problem) {
  fmt::print("{}: {:.3g} impulses per decay time, {}\n", problem.name,
             problem::impulses_per_decay_time(problem, problem::motion_scales(problem)),
             problem::non_default_parameters_text(problem));
  std::fflush(stdout);
}

void print_solutions(const SimulationReference& simulation_reference,
                     const std::vector<methods::Method>& methods,
                     const std::vector<MethodResult>& answers) {
  fmt::print("  {:20} {:>13} sampling L1 {:.1e} {:.1e}\n", "mcs", simulation_reference.status,
             simulation_reference.y_sampling_l1, simulation_reference.ydot_sampling_l1);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const MethodResult& a = answers[m];
    fmt::print("  {:20} {:>13} L1 {:.1e} {:.1e}", methods[m].id(), a.status, a.y_l1, a.ydot_l1);
    if (a.error_estimate)
      fmt::print(" estimate {:.1e} {:.1e}", a.error_estimate->y_l1, a.error_estimate->ydot_l1);
    fmt::print("  {:.2f} s  {}\n", a.seconds, a.reason);
  }
  std::fflush(stdout);
}

// Whether the distances of both marginals from the simulation are at most `safety` times the error
// estimate plus three times the expected sampling error.
bool is_within_estimate(const MethodResult& a, const SimulationReference& simulation_reference,
                        double safety) {
  if (!a.error_estimate) return false;
  return a.y_l1 <= safety * a.error_estimate->y_l1 + 3 * simulation_reference.y_sampling_l1 &&
         a.ydot_l1 <=
             safety * a.error_estimate->ydot_l1 + 3 * simulation_reference.ydot_sampling_l1;
}

// Whether a marginal is farther than `distance` from the simulation, by more than the sampling
// error.
bool is_farther_than(const MethodResult& a, const SimulationReference& simulation_reference,
                     double distance) {
  return a.y_l1 > distance + 1.5 * simulation_reference.y_sampling_l1 ||
         a.ydot_l1 > distance + 1.5 * simulation_reference.ydot_sampling_l1;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

void print_table(const std::vector<methods::Method>& methods,
                 const std::vector<SimulationReference>& references,
                 const std::vector<std::vector<MethodResult>>& answers) {
  fmt::print("\n{:18} {:>7} {:>4} {:>8} {:>10} {:>10} {:>9} {:>12} {:>12} {:>8} {:>8}\n", "method",
             "density", "ok", "unjudged", "ok, > 1 %", "ok, > 2 %", "worst ok", "> 2 estimate",
             "no estimate", "median s", "longest");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    int density = 0, ok = 0, unjudged = 0, one = 0, two = 0, beyond_estimate = 0,
        without_estimate = 0;
    double max_l1 = 0;
    std::vector<double> seconds;
    for (std::size_t p = 0; p < answers.size(); ++p) {
      const MethodResult& a = answers[p][m];
      density += a.density;
      seconds.push_back(a.seconds);
      if (a.status != "ok") continue;
      ++ok;
      if (!references[p].is_usable()) {
        ++unjudged;
        continue;
      }
      one += is_farther_than(a, references[p], 0.01);
      two += is_farther_than(a, references[p], 0.02);
      max_l1 = std::max(max_l1, a.max_l1());
      without_estimate += !a.error_estimate;
      beyond_estimate += a.error_estimate && !is_within_estimate(a, references[p], 2);
    }
    fmt::print("{:18} {:>7} {:>4} {:>8} {:>10} {:>10} {:>9.1e} {:>12} {:>12} {:>8.2f} {:>8.1f}\n",
               methods[m].id(), density, ok, unjudged, one, two, max_l1, beyond_estimate,
               without_estimate, quantile(seconds, 0.5), quantile(seconds, 1));
  }
}

// Prints the fraction of `ok` solutions by impulses per decay time and restitution coefficient.
void print_domain(const methods::Method& method, std::size_t m,
                  const std::vector<problem::Problem>& problems,
                  const std::vector<std::vector<MethodResult>>& answers) {
  const double rates[] = {0, 1, 3, 10, 100, HUGE_VAL};
  const double restitutions[] = {0, 0.4, 0.8, 1.01};
  fmt::print("\n{}: ok / all\n{:>28}", method.id(), "impulses per decay time");
  for (int i = 0; i < 5; ++i) {
    fmt::print("{:>12}", i == 4 ? "> 100" : fmt::format("{:g} .. {:g}", rates[i], rates[i + 1]));
  }
  for (int j = 0; j < 3; ++j) {
    fmt::print("\n{:>28}",
               fmt::format("r {:g} .. {:g}", restitutions[j], std::min(1.0, restitutions[j + 1])));
    for (int i = 0; i < 5; ++i) {
      int all = 0, ok = 0;
      for (std::size_t p = 0; p < problems.size(); ++p) {
        const double rate =
            problem::impulses_per_decay_time(problems[p], problem::motion_scales(problems[p]));
        const double r = problems[p].system.restitution();
        if (rate < rates[i] || rate >= rates[i + 1]) continue;
        if (r < restitutions[j] || r >= restitutions[j + 1]) continue;
        ++all;
        ok += answers[p][m].status == "ok";
      }
      fmt::print("{:>12}", fmt::format("{} / {}", ok, all));
    }
  }
  fmt::print("\n");
}

std::vector<int> problem_numbers(const Settings& settings) {
  std::vector<int> numbers;
  std::istringstream list(settings.numbers);
  for (std::string number; std::getline(list, number, ',');) numbers.push_back(std::stoi(number));
  for (int n = 0; settings.numbers.empty() && n < settings.count; ++n) {
    numbers.push_back(settings.first + n);
  }
  return numbers;
}

problem::Problem make_problem(int number, const Settings& settings) {
  const auto seed = static_cast<std::uint64_t>(number);
  if (settings.formulas) return tests::random_formula(seed);
  return settings.family ? tests::random_oscillator(seed) : tests::random_problem(seed);
}

const mcs::SimulationOptions kTails{.tails = true};

bool supports_tails(const problem::Problem& problem) {
  return mcs::unsupported_reason(problem, kTails).empty() &&
         mcs::unsupported_splitting_reason(problem, kTails).empty();
}

// The lowest density, relative to the peak, whose 95 % interval has at most half its value on a
// side.
double lowest_resolved_density(const Marginal& marginal) {
  const double peak = *std::ranges::max_element(marginal.density);
  double lowest = 1;
  for (std::size_t b = 0; b < marginal.size(); ++b) {
    if (compare::has_narrow_confidence_interval(marginal, b) && marginal.density[b] > 0) {
      lowest = std::min(lowest, marginal.density[b] / peak);
    }
  }
  return lowest;
}

void solve_tails(const problem::Problem& problem) {
  const auto solution = methods::solve_in_wall_coordinates(
      problem, {compare::comparison_bins(problem), {}},
      [](const problem::Problem&) { return std::string(); },
      [&](const problem::Problem& transformed,
          const methods::SolverInputContext& transformed_context) {
        mcs::SimulationOptions options = kTails;
        options.y_edges = transformed_context.axes.y_edges;
        options.v_edges = transformed_context.axes.v_edges;
        return mcs::simulate_stationary_density(transformed, options).solution;
      });
  fmt::print("  {:14}", name(solution.status));
  for (const auto& [variable, marginal] : solution.estimated_marginals) {
    fmt::print(" {:>8.1e}", lowest_resolved_density(marginal));
  }
  const auto levels = std::ranges::count_if(
      solution.metrics, [](const auto& o) { return o.path.starts_with("splitting_thresholds["); });
  fmt::print(" {:2} energies {}\n", levels, solution.reason);
}

// Solves each problem in a child process, to measure its memory and to limit it to kMostBytes.
void print_tails(const Settings& settings) {
  constexpr rlim_t kMostBytes = rlim_t{4} << 30;
  double most_megabytes = 0, longest = 0;
  int solved = 0, number = settings.first;
  for (; solved < settings.count; ++number) {
    const auto problem = make_problem(number, settings);
    if (!supports_tails(problem)) continue;
    ++solved;
    const auto begin = std::chrono::steady_clock::now();
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      const rlimit memory{kMostBytes, kMostBytes};
      setrlimit(RLIMIT_AS, &memory);
      try {
        solve_tails(problem);
      } catch (const std::exception& error) {
        fmt::print("  {}\n", error.what());
      }
      std::fflush(stdout);
      _exit(0);
    }
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double processor = static_cast<double>(used.ru_utime.tv_sec) +
                             1e-6 * static_cast<double>(used.ru_utime.tv_usec);
    const double megabytes = static_cast<double>(used.ru_maxrss) / 1024;
    most_megabytes = std::max(most_megabytes, megabytes);
    longest = std::max(longest, seconds);
    fmt::print("{:12} {:6.1f} s {:6.1f} s processor time {:7.0f} MB {}\n", problem.name, seconds,
               processor, megabytes, problem::non_default_parameters_text(problem));
  }
  fmt::print("{} of {} problems have tails: at most {:.1f} s and {:.0f} MB\n", solved,
             number - settings.first, longest, most_megabytes);
}

int run(const Settings& settings) {
  if (settings.tails) {
    print_tails(settings);
    return 0;
  }
  const auto registry = methods::builtin_registry();
  base::Values options;
  if (!settings.transport.empty()) options.push_back({"transport", settings.transport});
  const auto methods = registry.methods_selected_by_list(settings.methods, options);
  if (!settings.keep.empty()) std::filesystem::create_directories(settings.keep);
  std::vector<problem::Problem> problems;
  std::vector<SimulationReference> references;
  std::vector<std::vector<MethodResult>> answers;
  for (const int number : problem_numbers(settings)) {
    problems.push_back(make_problem(number, settings));
    if (problem::problem_features(problems.back()).collapse) {  // no solver and no reference
      problems.pop_back();
      continue;
    }
    const auto& problem = problems.back();
    if (settings.verbose) print_parameters(problem);
    const auto axes = compare::undivided_comparison_bins(compare::comparison_bins(problem));
    std::vector<Solution> solutions(methods.size());
    base::parallel_for(methods.size(), 0, [&](std::size_t m) {
      solutions[m] = methods::solve_with_method(methods[m], problem, {axes, {}});
    });
    // Only densities with status ok need a reference. The motion of a formula without such a
    // density may escape to amplitudes that take hours to simulate.
    const bool is_any_ok = std::ranges::any_of(
        solutions, [](const Solution& s) { return s.status == transform::Status::ok; });
    references.push_back(is_any_ok || !settings.formulas
                             ? simulation_reference(problem, axes, settings)
                             : SimulationReference{});
    std::vector<MethodResult> row;
    for (const Solution& solution : solutions) {
      row.push_back(compare_with_reference(references.back(), solution));
    }
    if (settings.verbose) print_solutions(references.back(), methods, row);
    answers.push_back(std::move(row));
  }
  print_table(methods, references, answers);
  for (std::size_t m = 0; m < methods.size() && !settings.family && !settings.formulas; ++m) {
    print_domain(methods[m], m, problems, answers);
  }
  return 0;
}

}  // namespace
}  // namespace fpkcheck::benchmarks

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  fpkcheck::benchmarks::Settings settings;
  po::options_description options("fpkcheck_random: random problems compared with the simulation");
  options.add_options()("help", "print this text")("count", po::value(&settings.count),
                                                   "number of problems")(
      "first", po::value(&settings.first), "number of the first problem")(
      "numbers", po::value(&settings.numbers),
      "problem numbers, separated by commas, in place of --count and --first")(
      "transport", po::value(&settings.transport), "option of fd: upwind or characteristics")(
      "methods", po::value(&settings.methods), "as for `fpkcheck run --methods`")(
      "keep", po::value(&settings.keep), "directory for stored simulations, to be reused")(
      "verbose", po::bool_switch(&settings.verbose), "print every solution")(
      "events", po::value(&settings.events), "largest number of events of a simulation")(
      "seconds", po::value(&settings.seconds), "longest time of a simulation")(
      "family", po::bool_switch(&settings.family),
      "problems of any oscillator, not only of the paper's oscillator")(
      "formulas", po::bool_switch(&settings.formulas),
      "oscillators whose force is a formula, also with noise.factor and r(u)")(
      "tails", po::bool_switch(&settings.tails),
      "time and memory of `fpkcheck mcs --tails` for the first `count` supported problems");
  try {
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, options), given);
    po::notify(given);
    if (given.contains("help")) {
      std::cout << options;
      return 0;
    }
    return fpkcheck::benchmarks::run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "fpkcheck_random: {}\n", error.what());
    return 2;
  }
}
