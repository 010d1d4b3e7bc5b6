#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "methods/external/external_methods.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kRunUsage = R"(usage: fpkcheck run [CASE ...] [options]

Solves each case (default: the four cases of the paper) by all methods, compares the marginal
densities p(y) and p(y'), splits the error of each closure by cause (error budget), prints tables
and draws figures. Methods, by increasing trust:
  epc   exponential-polynomial closures
        epc-gaussian-n2, -n4, -n6, -n8 (the closure of the paper: impact to first order in 1-r)
        epc-moment-n4, -n8, -n12 and epc-polar-n4, -n6, -n8 (exact equations)
  fd    finite volumes for white noise, the series truncated after order 4, and all jumps
        fd-white, fd-km4-delta (impact as in epc-gaussian), fd-km4, fd-kf
  mcs   simulation of the impact system, with control variates from the backward equation; all
        other methods are compared with it
Moments are compared with guaranteed bounds (fpkcheck bounds). Every density has a residual-based
error estimate (docs/residuals.md). Exit code 0 when finite volumes and simulation have status ok
and do not contradict the bounds; closures and first-order impacts may fail, because their accuracy
is the result of the run. With --methods, every method of the list must have status ok.

examples:
  fpkcheck run
  fpkcheck run case1 --set system.restitution=0.9 --methods epc-gaussian-n6,fd,mcs
  fpkcheck run mine.ini --out results --seed 7
  fpkcheck run hertz --set system.force='0.1*v + y - k*max(-y,0)^1.5' --methods fd,mcs
  fpkcheck run case1 --against measured_y.csv:lab --against measured_v.csv:lab
  fpkcheck run case1 --against mine.csv:mine,equation=km4,impact=delta,order=6
  fpkcheck run case1 --until 30
  fpkcheck run case1 --figures pdf,tex --figure-width 85 --curves epc-gaussian,mcs

A FILE of --against has one of these formats (docs/external.md), with or without a header line:
  p(y) or p(y')  columns "abscissa density", "abscissa density standard_error" or
                 "lower upper density_or_count"
  p(y, y')       columns y,v,p; netCDF-4, e.g. joint.nc of a run; or an exponential polynomial as
                 JSON, e.g. summary.json of a run
  samples        with samples=: columns y; y,v; or t,y,v
Keys after the label:
  equation=white|km4|km4-pade|kf  equation of the density: adds error estimate and error budget
  impact=map|delta|exact          impact condition of that equation (default: map)
  order=N                         order of the density, for its place among the closures
  samples=series|independent      samples instead of a density; series: a time series
  role=reference                  compare all methods with this density
  solution=ID, case=NAME          density to read from a file of a run
)";
constexpr const char* kDefaultDirectory = "fpkcheck-out";

}  // namespace

int run_command(const CommandInvocation& call) {
  if (requests_density_over_time(call)) return density_over_time_command(call);
  namespace po = boost::program_options;
  CommonCommandArguments common;
  base::Values given;
  std::optional<std::string> list;
  std::vector<std::string> against;
  std::optional<double> until;  // density_over_time_command() treats all runs with this option
  po::options_description own;
  own.add_options()(
      "methods", make_optional_option(list, "LIST"),
      "all, or solvers, families or ids of methods, separated by commas (default: epc,fd,mcs)");
  own.add_options()("until", make_optional_option(until, "T"),
                    "densities over time, 0 .. T, of one case; fpkcheck run --until T --help "
                    "lists the options");
  own.add_options()(
      "against", po::value(&against)->value_name("FILE[:LABEL][,KEY=VALUE]")->composing(),
      "also compare the density in FILE (formats above), for a single case; may be repeated. Files "
      "of p(y) and p(y') with the same LABEL (default: name of the file) form one solution");
  own.add(make_case_figure_options(common.figures));
  own.add(make_solver_run_options(call.registry, given));
  if (!parse_case_arguments(call.arguments, kRunUsage, own, common)) return kSuccess;

  auto methods = call.registry.methods_selected_by_list(
      list.value_or(call.registry.default_method_list()), given);
  if (common.cases.empty()) {
    for (const auto& named : problem::paper_cases()) common.cases.push_back(named.name);
  }
  if (!against.empty()) {
    if (common.cases.size() != 1) {
      throw InputError(fmt::format(
          "--against with {} cases: a density belongs to one case; name it", common.cases.size()));
    }
    // External densities come first among methods in the order of increasing trust, because their
    // accuracy is unknown.
    auto from_files = methods::external_density_methods_from_files(against, call.registry,
                                                                   load_cases(common).front().name);
    methods.insert(methods.begin(), std::make_move_iterator(from_files.begin()),
                   std::make_move_iterator(from_files.end()));
  }
  if (!common.out) common.out = kDefaultDirectory;
  std::vector<std::string> requested_ids;
  if (list) requested_ids = parse_comma_separated_list("--methods", *list);
  return solve_and_report(common, methods,
                          {.required = list ? SolutionsRequiredForSuccess::all
                                            : SolutionsRequiredForSuccess::references,
                           .requested_ids = requested_ids,
                           .threads = requested_thread_count(given),
                           .with_backward = true},
                          call.command_line);
}

int solver_command(const CommandInvocation& call, const methods::Solver& solver) {
  CommonCommandArguments common;
  base::Values values = solver.default_options;
  auto own = make_command_line_options(*solver.option_descriptions, values);
  own.add(make_case_figure_options(common.figures));
  if (!parse_case_arguments(call.arguments, solver.usage, own, common)) return kSuccess;
  return solve_and_report(common, {call.registry.make_method(solver, values)},
                          {.required = SolutionsRequiredForSuccess::all}, call.command_line);
}

}  // namespace fpkcheck::cli
