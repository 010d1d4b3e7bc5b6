#include <fmt/format.h>

#include <vector>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "base/text/printable_text.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"
#include "methods/case_results.hpp"
#include "report/findings.hpp"
#include "results/run_json.hpp"
#include "results/saved_run.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kBoundsUsage = R"(usage: fpkcheck bounds CASE ... [options]

Guaranteed lower and upper bounds of stationary expectations of the oscillator under impulses
(equation kf, exact impact): E[y], E[y^2], E[y'^2], E[y^4], E[y'^4] and the momentum of the impacts
w1 = int u^2 p(0,-u) du. The bounds depend on no solver: outward-rounded interval arithmetic checks
an approximate solution of the backward equation. Theorem and proof: docs/bounds.md.
Exit code 0 when all bounds have the requested width. Exit code 1 when no bounds exist, or when
some bounds are wider; the last line then names the limit: --seconds or the finest grid.

examples:
  fpkcheck bounds case1
  fpkcheck bounds case1 --width 5e-6 --seconds 60
  fpkcheck bounds case1 --bin ydot:0.5:0.3          average of p(y') around 0.5
)";

backward::StationaryFunctional parse_smooth_bin(const std::string& text) {
  const auto refuse = [&] {
    throw InputError(
        fmt::format("--bin {} (must be y:CENTRE:SPACING or ydot:CENTRE:SPACING, as ydot:0.5:0.3)",
                    base::in_quotes(text)));
  };
  const auto first = text.find(':'), second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) refuse();
  const std::string variable = text.substr(0, first);
  if (variable != "y" && variable != "ydot") refuse();
  const auto number = [&](const std::string& part) {
    const auto found = base::Parameter{.name = "bin", .help = {}}.parse(part);
    if (!found) refuse();
    return std::get<double>(*found);
  };
  return backward::SmoothBin::with_equidistant_knots(
      variable == "y" ? backward::StateVariable::y : backward::StateVariable::ydot,
      number(text.substr(first + 1, second - first - 1)), number(text.substr(second + 1)));
}

}  // namespace

int bounds_command(const CommandInvocation& call) {
  namespace po = boost::program_options;
  CommonCommandArguments common;
  const auto& description = backward::bounds_option_descriptions();
  base::Values values = description.values(backward::BoundsOptions{});
  std::vector<std::string> bins;
  po::options_description own = make_command_line_options(description, values);
  own.add_options()(
      "bin", po::value(&bins)->value_name("V:X:H")->composing(),
      "also bound the average of p(y) or p(y') weighted by a cubic B-spline with centre X and knot "
      "spacing H; V is y or ydot; may be repeated");
  if (!parse_case_arguments(call.arguments, kBoundsUsage, own, common,
                            "write summary.json to DIR (default: no file)")) {
    return kSuccess;
  }
  if (common.cases.empty()) throw InputError("no case; name one, e.g. case1");
  backward::BoundsOptions options = description.read(values, "options");
  for (const auto& bin : bins) options.functionals.push_back(parse_smooth_bin(bin));
  backward::require_valid_bounds_options(options);
  const auto problems = load_cases(common);
  const OutputDirectory directory(common.out);

  results::Run run{results::current_program(call.command_line), {}};
  bool reached = true;
  for (const auto& problem : problems) {
    run.cases.push_back(
        {.problem = problem, .bounds = methods::compute_guaranteed_bounds(problem, options)});
    throw_if_interrupted();
    const auto& bounds = *run.cases.back().bounds;
    const bool found = bounds.reason.empty() && !bounds.each.empty();
    reached = reached && found;
    if (common.quiet && !found) print_message(fmt::format("{}: {}", problem.name, bounds.reason));
    if (common.json || common.quiet) continue;
    print_output(fmt::format("{}{:.1f} s\n",
                             report::guaranteed_bounds_table(problem, bounds, terminal_format()),
                             bounds.seconds));
  }
  if (common.json) print_output(results::run_summary_text(run) + '\n');
  if (common.out) {
    const base::ProcessExitBlocker in_hand;
    base::FileTransaction files;
    files.add(std::filesystem::path(*common.out) / results::kSummaryFile,
              results::run_summary_text(run) + '\n');
    files.commit();
    set_exit_message("all files were written");
  }
  return reached ? kSuccess : kFailure;
}

}  // namespace fpkcheck::cli
