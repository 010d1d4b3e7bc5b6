#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/simulation_options.hpp"
#include "cli/solve_and_report.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck mcs CASE ... [options]

Simulates the impact system itself: impulses at their exact times, impacts located by root
finding, independent streams whose differences give the standard errors and 95 % intervals.

examples:
  fpkcheck mcs case1 --seed 7
  fpkcheck mcs case1 --time 1e6 --json
)";

}  // namespace

int mcs_command(const std::vector<std::string>& arguments, const std::string& command_line) {
  namespace po = boost::program_options;
  CommonArguments common;
  mcs::Options options;
  po::options_description own;
  own.add_options()("streams",
                    po::value(&options.streams)->value_name("N")->default_value(options.streams),
                    "independent streams");
  own.add(simulation_options(options));
  if (!parse(arguments, kUsage, with_common_options(own, common), common.cases)) return 0;
  return solve_and_report(common, {compare::mcs_method(options)}, options.threads, Required::all,
                          command_line);
}

}  // namespace fpkcheck::cli
