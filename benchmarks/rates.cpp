#include <fmt/format.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "compare/comparison_bins.hpp"
#include "exact/closed_forms.hpp"
#include "fd_fpk/solve.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "rate_scan.hpp"
#include "transform/solution.hpp"

// Case 1 with impulses of one intensity, at all rates, of all laws, with several restitution
// coefficients. For each method: the number of `ok` solutions, whether they have error estimates,
// and whether the errors are within the estimates. The reference is fd-kf with cells half as wide;
// for r = 1, E[y'^2] is also known exactly.
//
//   fpkcheck_rates [--rates 1e-4,..] [--laws gaussian,..] [--restitutions 0.5,..] [--methods fd]
//                  [--max-seconds 20] [--verbose]
namespace fpkcheck::benchmarks {
namespace {

using transform::Solution;
using transform::StateVariable;

struct Settings {
  tests::RateScan scan = {};
  std::string methods = "fd,epc";
  double max_seconds = 20;
  bool verbose = false;
};

// Statistics of a method's solutions over all problems.
struct MethodStatistics {
  int ok = 0, without_estimate = 0, judged = 0, beyond_estimate = 0;
  double worst = 0, worst_ratio = 0;
};

// Whether a solution approximates the full problem; other equations are not compared with it.
bool solves_the_full_problem(const Solution& solution) {
  return solution.identity.role != transform::SolutionRole::equation ||
         (solution.identity.equation == problem::DensityEquation::kf &&
          solution.identity.impact == problem::ImpactCondition::map);
}

std::optional<Solution> reference_solution(const problem::Problem& problem) {
  constexpr double kFiner = 2, kSeconds = 300;
  for (const auto transport : {std::optional<fd_fpk::TransportScheme>(),
                               std::optional(fd_fpk::TransportScheme::characteristics)}) {
    try {
      auto solution =
          fd_fpk::solve_stationary_density(problem, {.stepper = fd_fpk::StationarySolver::direct,
                                                     .transport = transport,
                                                     .refinement = kFiner,
                                                     .max_seconds = kSeconds})
              .solution;
      if (solution.has_status_ok()) return solution;
    } catch (const std::exception&) {  // this transport does not support the problem
    }
  }
  return std::nullopt;
}

// The largest L1 error of p(y) and p(y'), and the largest ratio of an error to its estimate, also
// for E[y'^2] where it is known. The reference's own error estimate is subtracted.
struct Comparison {
  double l1 = 0, ratio = 0;
};
Comparison judged(const problem::Problem& problem, const Solution& solution,
                  const Solution& reference_solution, const compare::ComparisonBins& axes) {
  Comparison result;
  for (const auto variable : transform::kVariables) {
    const auto& edges = compare::comparison_bin_edges(axes, variable);
    const double l1 =
        transform::l1_distance(transform::marginal(solution, variable, edges),
                               transform::marginal(reference_solution, variable, edges));
    const double own = transform::l1_error_of_marginal(*reference_solution.error, variable);
    result.l1 = std::max(result.l1, l1);
    result.ratio = std::max(
        result.ratio, (l1 - own) / transform::l1_error_of_marginal(*solution.error, variable));
  }
  if (problem.system.restitution() == 1 &&
      solution.identity.role == transform::SolutionRole::equation) {
    constexpr double kRounding = 1e-6;
    const double off =
        std::abs(solution.moments.v2 - exact::mean_square_velocity(problem)) - kRounding;
    result.ratio = std::max(result.ratio, off / solution.error->moments.v2);
  }
  return result;
}

void add(const problem::Problem& problem, const Solution& solution,
         const std::optional<Solution>& reference_solution, const compare::ComparisonBins& axes,
         const Settings& settings, MethodStatistics& tally) {
  constexpr double kSafetyFactor = 2;
  std::string text;
  const bool states = transform::has_error_estimate(solution);
  if (solution.has_status_ok()) {
    ++tally.ok;
    if (!states) ++tally.without_estimate;
  }
  if (solution.error) {
    text = fmt::format("{:.1e} {:.1e}", solution.error->y_l1, solution.error->ydot_l1);
  }
  if (solution.has_status_ok() && states && reference_solution && solution.error &&
      solves_the_full_problem(solution)) {
    const Comparison found = judged(problem, solution, *reference_solution, axes);
    ++tally.judged;
    tally.worst = std::max(tally.worst, found.l1);
    tally.worst_ratio = std::max(tally.worst_ratio, found.ratio);
    if (found.ratio > kSafetyFactor) ++tally.beyond_estimate;
    text += fmt::format("  L1 {:.1e}, {:.2g} of the estimate", found.l1, found.ratio);
  }
  if (!settings.verbose) return;
  fmt::print("  {:18} {:>13} {:.1f} s  {}  {}\n", solution.id(), name(solution.status),
             solution.seconds, text, solution.reason);
  std::fflush(stdout);
}

int run(const Settings& settings) {
  const auto registry = methods::builtin_registry();
  const auto methods =
      registry.methods_selected_by_list(settings.methods, {{"max_seconds", settings.max_seconds}});
  std::vector<MethodStatistics> tallies(methods.size());
  int problems = 0;
  for (const auto& problem : settings.scan.problems()) {
    const auto axes = compare::undivided_comparison_bins(compare::comparison_bins(problem));
    const auto reference = reference_solution(problem);
    if (settings.verbose) {
      fmt::print("{} ({})\n", problem.name, reference ? "with reference" : "no reference");
    }
    const auto solved = methods::run_cases({problem}, methods, 1, {}).front();
    ++problems;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      add(problem, solved.solutions[m], reference, axes, settings, tallies[m]);
    }
  }
  fmt::print("\n{:18} {:>8} {:>5} {:>13} {:>7} {:>9} {:>12} {:>18}\n", "method", "problems", "ok",
             "no estimate", "judged", "worst L1", "> 2 estimate", "worst / estimate");
  int without_estimate = 0;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const MethodStatistics& t = tallies[m];
    without_estimate += t.without_estimate;
    fmt::print("{:18} {:>8} {:>5} {:>13} {:>7} {:>9.1e} {:>12} {:>18.2g}\n", methods[m].id(),
               problems, t.ok, t.without_estimate, t.judged, t.worst, t.beyond_estimate,
               t.worst_ratio);
  }
  return without_estimate == 0 ? 0 : 1;
}

std::vector<std::string> split_list(const std::string& list) {
  std::vector<std::string> all;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) all.push_back(word);
  return all;
}

std::vector<double> parse_numbers(const std::string& list) {
  std::vector<double> all;
  for (const auto& word : split_list(list)) all.push_back(std::stod(word));
  return all;
}

}  // namespace
}  // namespace fpkcheck::benchmarks

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  using fpkcheck::benchmarks::parse_numbers, fpkcheck::benchmarks::split_list;
  fpkcheck::benchmarks::Settings settings;
  std::string rates, laws, restitutions;
  po::options_description options("fpkcheck_rates: case 1 with impulses at all rates");
  options.add_options()("help", "print this text")(
      "rates", po::value(&rates), "list, separated by commas")("laws", po::value(&laws),
                                                               "list, separated by commas")(
      "restitutions", po::value(&restitutions), "list, separated by commas")(
      "methods", po::value(&settings.methods), "as for `fpkcheck run --methods`")(
      "max-seconds", po::value(&settings.max_seconds), "time limit of a solution")(
      "verbose", po::bool_switch(&settings.verbose), "print every solution");
  try {
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, options), given);
    po::notify(given);
    if (given.count("help") > 0) {
      std::cout << options;
      return 0;
    }
    if (!rates.empty()) settings.scan.rates = parse_numbers(rates);
    if (!laws.empty()) settings.scan.laws = split_list(laws);
    if (!restitutions.empty()) settings.scan.restitutions = parse_numbers(restitutions);
    return fpkcheck::benchmarks::run(settings);
  } catch (const std::exception& error) {
    std::cerr << "fpkcheck_rates: " << error.what() << '\n';
    return 2;
  }
}
