#include <fmt/format.h>

#include <iterator>
#include <optional>

#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/simulation_options.hpp"
#include "cli/solve_and_report.hpp"
#include "compare/foreign/foreign_methods.hpp"
#include "problem/input_error.hpp"
#include "problem/named_cases.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck run [CASE ...] [options]

Solves each case (default: the paper's four) by all methods, compares the marginal densities
p(y) and p(y'), splits the error of each closure into its causes (error budget), prints
tables and draws pictures. Methods, by increasing trust:
  epc   exponential-polynomial closures
        epc-gaussian-n2, -n4, -n6, -n8 (the paper's: impact to first order in 1-r)
        epc-moment-n4, -n8, -n12 and epc-polar-n4, -n6, -n8 (exact moment equations)
  fd    finite differences: white noise, series cut after the 4th derivative, all jumps
        fd-white, fd-km4-delta (impact to first order in 1-r, as in epc-gaussian), fd-km4, fd-kf
  mcs   simulation of the impact system itself
Exit code 0 when finite differences and simulation reached their solutions: how far the
closures and the impact to first order carry is what the run finds out. With --methods, every
method of the list must reach one.

examples:
  fpkcheck run
  fpkcheck run case1 --set system.restitution=0.9 --methods epc-gaussian-n6,fd,mcs
  fpkcheck run mine.ini --out results --seed 7
  fpkcheck run case1 --against measured_y.csv:lab --against measured_v.csv:lab

A FILE of --against has the columns "abscissa density", "abscissa density standard_error" or
"lower upper density_or_count" of p(y) or p(y'), with a line of names or not (docs/foreign.md).
)";
constexpr const char* kAllMethods = "epc,fd,mcs";
constexpr const char* kDefaultDirectory = "fpkcheck-out";

}  // namespace

int run_command(const std::vector<std::string>& arguments, const std::string& command_line) {
  namespace po = boost::program_options;
  CommonArguments common;
  mcs::Options simulation;
  std::optional<std::string> list;
  std::vector<std::string> against;
  po::options_description own;
  own.add_options()("methods",
                    po::value<std::string>()->value_name("LIST")->notifier(
                        [&list](const std::string& value) { list = value; }),
                    "families or ids separated by commas (default: epc,fd,mcs)");
  own.add_options()(
      "against", po::value(&against)->value_name("FILE[:LABEL]")->composing(),
      "compare a marginal density from a file as well; of one case; may be repeated: y and y' of "
      "the same LABEL (default: the file's name) are one solution");
  own.add(simulation_options(simulation));
  if (!parse(arguments, kUsage, with_common_options(own, common), common.cases)) return 0;

  const bool chosen = list.has_value();
  auto methods = compare::select_methods(list.value_or(kAllMethods), simulation);
  if (common.cases.empty()) {
    for (const auto& named : problem::named_cases()) common.cases.push_back(named.name);
  }
  if (!against.empty()) {
    if (common.cases.size() != 1) {
      throw InputError(fmt::format("--against with {} cases (a file is of one case: name it)",
                                   common.cases.size()));
    }
    // Before the others: nothing is known of how far they may be trusted.
    auto foreign = compare::foreign_methods(against);
    methods.insert(methods.begin(), std::make_move_iterator(foreign.begin()),
                   std::make_move_iterator(foreign.end()));
  }
  if (!common.out) common.out = kDefaultDirectory;
  return solve_and_report(common, methods, simulation.threads,
                          chosen ? Required::all : Required::references, command_line);
}

}  // namespace fpkcheck::cli
