#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/figure_options.hpp"
#include "cli/lists.hpp"
#include "cli/parameter_options.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "methods/external/external_methods.hpp"
#include "problem/named_cases.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kRunUsage = R"(usage: fpkcheck run [CASE ...] [options]

Solves each case (default: the paper's four) by all methods, compares the marginal densities
p(y) and p(y'), splits the error of each closure into its causes (error budget), prints
tables and draws pictures. Methods, by increasing trust:
  epc   exponential-polynomial closures
        epc-gaussian-n2, -n4, -n6, -n8 (the paper's: impact of first order)
        epc-moment-n4, -n8, -n12 and epc-polar-n4, -n6, -n8 (exact equations)
  fd    finite differences: white noise, series cut after order 4, all jumps
        fd-white, fd-km4-delta (impact as in epc-gaussian), fd-km4, fd-kf
  mcs   simulation of the impact system itself, its noise taken out by the backward equation:
        all others are measured by it
Moments are held to guaranteed bounds (fpkcheck bounds), and every density tells its own error
by its residuals (docs/residuals.md). Exit code 0 when finite differences and
simulation reached their solutions and do not contradict the bounds: how far the closures and
the impact to first order carry is what the run finds out. With --methods, every method of the
list must reach one.

examples:
  fpkcheck run
  fpkcheck run case1 --set system.restitution=0.9 --methods epc-gaussian-n6,fd,mcs
  fpkcheck run mine.ini --out results --seed 7
  fpkcheck run case1 --against measured_y.csv:lab --against measured_v.csv:lab
  fpkcheck run case1 --against mine.csv:mine,equation=km4,impact=delta,order=6
  fpkcheck run case1 --figures pdf,tex --figure-width 85 --curves epc-gaussian,mcs

A FILE of --against has the columns "abscissa density", "abscissa density standard_error" or
"lower upper density_or_count" of p(y) or p(y'), with a line of names or not; or the columns y,v,p
of a joint density, or one as netCDF-4 (joint.nc of a run too); or an exponential polynomial as JSON
(summary.json of a run too). All of it in docs/foreign.md. After the label may follow
  equation=white|km4|km4-pade|kf  what it is meant to solve: it gets an error and an error budget
  impact=map|delta|exact          of that equation (default: map)
  order=N                         where it stands among the closures
  solution=ID, case=NAME          of a file of a run: which density
)";
constexpr const char* kDefaultDirectory = "fpkcheck-out";

// All solvers of the registry.
std::string all_methods(const methods::Registry& registry) {
  std::string list;
  for (const auto& solver : registry.solvers()) list += solver.name + ',';
  return list;
}

}  // namespace

int run_command(const Call& call) {
  namespace po = boost::program_options;
  CommonArguments common;
  base::Values given;
  std::optional<std::string> list;
  std::vector<std::string> against;
  po::options_description own;
  own.add_options()("methods",
                    po::value<std::string>()->value_name("LIST")->notifier(
                        [&list](const std::string& value) { list = value; }),
                    "solvers, families or ids separated by commas (default: all solvers)");
  own.add_options()(
      "against", po::value(&against)->value_name("FILE[:LABEL][,KEY=VALUE]")->composing(),
      "compare a density from a file as well, see above; of one case; may be repeated: marginals "
      "of y and y' of the same LABEL (default: the file's name) are one solution");
  own.add(case_figure_options(common.figures));
  own.add(options_of_a_run(call.registry, given));
  if (!parse(call.arguments, kRunUsage, with_common_options(own, common), common.cases))
    return kDone;

  auto methods = call.registry.select(list.value_or(all_methods(call.registry)), given);
  if (common.cases.empty()) {
    for (const auto& named : problem::paper_cases()) common.cases.push_back(named.name);
  }
  if (!against.empty()) {
    if (common.cases.size() != 1) {
      throw InputError(fmt::format("--against with {} cases (a file is of one case: name it)",
                                   common.cases.size()));
    }
    // Before the others: nothing is known of how far they may be trusted.
    auto from_files =
        methods::external_methods(against, call.registry, load_cases(common).front().name);
    methods.insert(methods.begin(), std::make_move_iterator(from_files.begin()),
                   std::make_move_iterator(from_files.end()));
  }
  if (!common.out) common.out = kDefaultDirectory;
  std::vector<std::string> named;
  if (list) named = items("--methods", *list);
  return solve_and_report(common, methods,
                          {.required = list ? Required::all : Required::references,
                           .named = named,
                           .threads = threads_in(given),
                           .with_backward = true},
                          call.command_line);
}

}  // namespace fpkcheck::cli
