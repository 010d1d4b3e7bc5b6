#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/standard_streams.hpp"
#include "problem/features.hpp"
#include "workflows/sweep/report/advice_text.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kAdviseUsage = R"(usage: fpkcheck advise CASE [options]

Which method for this problem? Says at once, without solving anything, what to type for an accuracy:
the quickest method that kept it at all problems nearby out of two thousand that were solved by all
closures and finite differences (docs/validity.md), what else there is, and what misleads there.
Near is what has about the same number of impulses per decay time, damping ratio, share of the
stiffness that is cubic, restitution and law of the impulses, in whatever units.
Errors are distances of p(y) and p(y') from the density of the problem itself in L1, which is 0 for
equal densities and 2 for disjoint ones. Closures that are off by more than 0.02 do not say ok and
are not promised, whatever is asked for.
Exit code 0 when a method is promised, 1 when none is.

examples:
  fpkcheck advise case1
  fpkcheck advise mine.ini --accuracy 0.001
  fpkcheck advise case1 --set system.restitution=0.8 --set impulse.rate=0.1
)";

// As a shell reads it back.
std::string in_shell(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_./=:,+-").find(char(c)) != std::string::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

std::string words_of_case(const CommonArguments& common) {
  std::string words = in_shell(common.cases.front());
  for (const auto& one : common.overrides) words += " --set " + in_shell(one);
  return words;
}

// What tells the solver's members apart: the closures' formulation and order.
std::set<std::string> telling_options(const methods::Solver& solver) {
  std::set<std::string> telling;
  std::map<std::string, base::Value> first;
  for (const auto& family : solver.families) {
    for (const auto& id : family.default_ids) {
      const auto options = solver.options_of(id);
      if (!options) continue;
      for (const auto& [name, value] : *options) {
        if (first.emplace(name, value).first->second != value) telling.insert(name);
      }
    }
  }
  return telling;
}

// The command of a method's solver, with what tells the method from others and is not as usual.
std::string command_of(const std::string& id, const std::string& words,
                       const methods::Registry& registry) {
  // Finite differences as the map has them: without stepping.
  const auto method = registry.method_by_id(id, {{"stepper", std::string("direct")}});
  const auto* solver = method ? registry.find(method->identity.method) : nullptr;
  if (solver == nullptr) return fmt::format("fpkcheck run {} --methods {}", words, id);
  const auto telling = telling_options(*solver);
  std::string command = fmt::format("fpkcheck {} {}", solver->name, words);
  for (const auto& option : method->options) {
    const auto* parameter = solver->option_descriptions->find(option.name);
    const auto usual =
        std::ranges::find(solver->default_options, option.name, &base::NamedValue::name);
    if (parameter == nullptr || parameter->flag.empty()) continue;
    if (base::is_unset(option.value)) continue;
    if (*usual == option && !telling.contains(option.name)) continue;
    const auto* word = std::get_if<std::string>(&option.value);
    command += fmt::format(" --{} {}", parameter->flag,
                           word != nullptr ? *word : base::text_of(option.value));
  }
  return command;
}

}  // namespace

int advise_command(const Call& call) {
  namespace po = boost::program_options;
  CommonArguments common;
  double accuracy = 0.01;
  po::options_description options("options", 96);
  options.add_options()("accuracy",
                        po::value(&accuracy)->value_name("L1")->default_value(accuracy, "0.01"),
                        "largest error of p(y) and of p(y') in L1")(
      "set", po::value(&common.overrides)->value_name("KEY=VALUE")->composing(),
      "override a key of the case, e.g. --set system.restitution=0.9; may be repeated")(
      "json", po::bool_switch(&common.json),
      "print it as JSON on standard output, with all methods")("help,h", "this text");
  if (!parse(call.arguments, kAdviseUsage, options, common.cases)) return kDone;
  if (common.cases.size() != 1) throw InputError("advise takes one case (name it, e.g. case1)");
  if (!(accuracy > 0 && accuracy <= 2)) {
    throw InputError(fmt::format("--accuracy {:g} (must be above 0 and at most 2)", accuracy));
  }
  const auto problem = load_cases(common).front();
  if (!problem::is_paper_oscillator(problem)) {
    throw InputError(fmt::format(
        "{}: the map of validity holds one wall at the equilibrium, constant damping and impulses alone "
        "(fpkcheck run {} compares the methods there)",
        problem.name, common.cases.front()));
  }
  const auto advice = sweep::advice(problem, accuracy, sweep::shipped_validity_map());

  const std::string words = words_of_case(common);
  // Finer grids follow until an error of 1e-4 is stated; beyond that they have to be asked for.
  constexpr double kUsualGrids = 1e-4;
  const sweep::AdviceContext setting{
      .name = problem.name,
      .command = [&](const std::string& id) { return command_of(id, words, call.registry); },
      .fallback_commands = {fmt::format("fpkcheck fd {} --{} {:g}", words,
                                        accuracy < kUsualGrids ? "tolerance" : "accuracy",
                                        accuracy),
                            fmt::format("fpkcheck mcs {}", words)},
      .registry = call.registry};
  put_out(common.json ? sweep::advice_json(advice, setting, call.command_line) + '\n'
                      : sweep::advice_text(advice, setting, terminal_format()));
  return advice.promised().empty() ? kNotReached : kDone;
}

}  // namespace fpkcheck::cli
