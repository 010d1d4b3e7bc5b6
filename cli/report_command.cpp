#include "base/input_error.hpp"
#include "base/process/exit_blocker.hpp"
#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/figure_options.hpp"
#include "cli/program.hpp"
#include "cli/shutdown.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/standard_streams.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/report.hpp"
#include "report/supplement.hpp"
#include "results/saved_run.hpp"
#include "workflows/paper/judge_claims.hpp"
#include "workflows/paper/supplement.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kReportUsage = R"(usage: fpkcheck report DIR [options]

Prints the table of a saved run and rebuilds its report.html and figures; for a run of `paper` also
the claims and the figures of the paper. DIR is the directory of the run. Solves nothing.
)";

}  // namespace

int report_command(const CommandCall& call) {
  namespace po = boost::program_options;
  std::vector<std::string> directories;
  po::options_description options("options", 96);
  bool quiet = false;
  report::FigureOptions figures;
  const auto case_options = make_case_figure_options(figures);
  for (const auto& option : case_options.options()) options.add(option);
  options.add_options()("quiet,q", po::bool_switch(&quiet), "print no table")("help,h",
                                                                              "print this text");
  if (!parse_arguments(call.arguments, kReportUsage, options, directories)) return kSuccess;
  if (directories.size() != 1) {
    throw InputError("report takes one directory; name that of a saved run, e.g. fpkcheck-out");
  }
  results::Run run = results::load_run(directories.front());
  call.registry.complete_identities(run);
  std::vector<transform::SolutionIdentity> identities;
  for (const auto& case_result : run.cases) {
    for (const auto& solution : case_result.solutions) identities.push_back(solution.identity);
  }
  report::validate_curves(figures.curves, identities);
  const base::ExitBlocker in_hand;
  const auto format = terminal_format();
  const auto supplement =
      paper::is_paper_run(run)
          ? paper::claims_supplement(paper::judge_claims(run), run, figures.width, format)
          : report::Supplement{};
  const auto [text, warnings] =
      report::rebuild_report(directories.front(), run, format, figures, supplement);
  set_exit_message("report.html was written, but not all figures");
  if (!quiet) print_output(text);
  for (const auto& warning : warnings) print_message(warning);
  return kSuccess;
}

}  // namespace fpkcheck::cli
