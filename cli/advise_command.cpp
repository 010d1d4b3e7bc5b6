#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/terminal.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/problem_features.hpp"
#include "workflows/sweep/report/recommendation_text.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kAdviseUsage = R"(usage: fpkcheck advise CASE [options]

Recommends the command for a required accuracy of the case, without solving the case. The method
is the fastest that met the accuracy in all similar problems, among two thousand problems solved
by all closures and finite volumes (docs/validity.md). Also lists the alternatives, and methods
that underestimate their errors in similar problems.
Similar problems have about the same number of impulses per decay time, damping ratio, cubic
fraction of the stiffness, restitution coefficient and impulse law. Units do not matter.
Errors are L1 distances of p(y) and p(y') from the density of the problem: 0 for equal densities,
2 for disjoint densities. Closures with an error above 0.02 are never recommended, since they have
no status ok.
Exit code 0 when a method is recommended, 1 when no method is recommended.

examples:
  fpkcheck advise case1
  fpkcheck advise mine.ini --accuracy 0.001
  fpkcheck advise case1 --set system.restitution=0.8 --set impulse.rate=0.1
)";

// Returns a text, quoted if necessary, as one argument of a POSIX shell command.
std::string quote_for_shell(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_./=:,+-").find(char(c)) != std::string::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

std::string case_arguments(const CommonCommandArguments& common) {
  std::string words = quote_for_shell(common.cases.front());
  for (const auto& override_text : common.overrides)
    words += " --set " + quote_for_shell(override_text);
  return words;
}

// Returns the names of the options that differ between the methods of a solver, e.g. the
// formulation and the order of closures.
std::set<std::string> distinguishing_options(const methods::Solver& solver) {
  std::set<std::string> distinguishing;
  std::map<std::string, base::Value> first;
  for (const auto& family : solver.families) {
    for (const auto& id : family.default_ids) {
      const auto options = solver.options_of(id);
      if (!options) continue;
      for (const auto& [name, value] : *options) {
        if (first.emplace(name, value).first->second != value) distinguishing.insert(name);
      }
    }
  }
  return distinguishing;
}

// Returns the command that solves a case by a method, with all options that differ from their
// defaults.
std::string method_command(const std::string& id, const std::string& words,
                           const methods::SolverRegistry& registry) {
  // The validity map has results of `fd` from the direct solver, which makes no time steps.
  const auto method = registry.find_method_by_id(id, {{"stepper", std::string("direct")}});
  const auto* solver = method ? registry.find_solver(method->identity.method) : nullptr;
  if (solver == nullptr) return fmt::format("fpkcheck run {} --methods {}", words, id);
  const auto distinguishing = distinguishing_options(*solver);
  std::string command = fmt::format("fpkcheck {} {}", solver->name, words);
  for (const auto& option : method->options) {
    const auto* parameter = solver->option_descriptions->find(option.name);
    const auto usual =
        std::ranges::find(solver->default_options, option.name, &base::NamedParameterValue::name);
    if (parameter == nullptr || parameter->flag.empty()) continue;
    if (base::is_unset(option.value)) continue;
    if (*usual == option && !distinguishing.contains(option.name)) continue;
    const auto* word = std::get_if<std::string>(&option.value);
    command += fmt::format(" --{} {}", parameter->flag,
                           word != nullptr ? *word : base::value_as_text(option.value));
  }
  return command;
}

}  // namespace

int advise_command(const CommandInvocation& call) {
  namespace po = boost::program_options;
  CommonCommandArguments common;
  double accuracy = 0.01;
  po::options_description options("options", 96);
  options.add_options()("accuracy",
                        po::value(&accuracy)->value_name("L1")->default_value(accuracy, "0.01"),
                        "largest L1 error of p(y) and of p(y'), above 0 and at most 2")(
      "set", po::value(&common.overrides)->value_name("KEY=VALUE")->composing(),
      "override a key of the case, e.g. --set system.restitution=0.9; may be repeated")(
      "json", po::bool_switch(&common.json), "print JSON with all methods to standard output")(
      "help,h", "print this text");
  if (!parse_arguments(call.arguments, kAdviseUsage, options, common.cases)) return kSuccess;
  if (common.cases.size() != 1) throw InputError("advise takes one case; name it, e.g. case1");
  if (!(accuracy > 0 && accuracy <= 2)) {
    throw InputError(fmt::format("--accuracy {:g} (must be above 0 and at most 2)", accuracy));
  }
  const auto problem = load_cases(common).front();
  if (!problem::has_equivalent_linearisation(problem)) {
    throw InputError(fmt::format(
        "{}: not in the validity map, which has one wall at equilibrium, constant damping and no "
        "noise; use fpkcheck run {}",
        problem.name, common.cases.front()));
  }
  const auto advice = sweep::recommend_methods(problem, accuracy, sweep::shipped_validity_map());

  const std::string words = case_arguments(common);
  // By default the method `fd` refines its grid until its error estimate is below 1e-4.
  constexpr double kDefaultGridTolerance = 1e-4;
  const sweep::RecommendationContext setting{
      .name = problem.name,
      .command = [&](const std::string& id) { return method_command(id, words, call.registry); },
      .fallback_commands = {fmt::format("fpkcheck fd {} --{} {:g}", words,
                                        accuracy < kDefaultGridTolerance ? "tolerance" : "accuracy",
                                        accuracy),
                            fmt::format("fpkcheck mcs {}", words)},
      .registry = call.registry};
  print_output(common.json ? sweep::recommendation_json(advice, setting, call.command_line) + '\n'
                           : sweep::recommendation_text(advice, setting, terminal_format()));
  return advice.sufficiently_accurate_methods().empty() ? kFailure : kSuccess;
}

}  // namespace fpkcheck::cli
