#include <fmt/format.h>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "base/process/stopwatch.hpp"
#include "cli/command_line.hpp"
#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"
#include "report/figure/curve_selection.hpp"
#include "report/report_supplement.hpp"
#include "report/write_report.hpp"
#include "results/saved_run.hpp"
#include "workflows/check/baseline.hpp"
#include "workflows/check/compare_runs.hpp"
#include "workflows/paper/claims_supplement.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kCheckUsage = R"(usage: fpkcheck check BASELINE.json [options]

Regression test: repeats the run of a summary.json and compares statuses, moments, mass, balance of
power, coefficients of closures, distances, and the densities of marginals.csv in its directory.
The directory of any run can be the baseline: keep the directory of a verified run.
The tolerance is --tolerance for deterministic methods and --standard-errors for the simulation;
with the same seed the simulation normally reproduces all its numbers. Prints all changes beyond
the tolerance, and the largest change of each kind.
Exit code 0 when all quantities agree, 1 when a quantity changed, 2 when the baseline is unusable.

examples:
  fpkcheck run mine.ini --out baseline                      (make a baseline)
  fpkcheck check baseline/summary.json                      (compare with the baseline)
  fpkcheck check baseline/summary.json --out changed        (keep the new run, too)
)";

void write_check_files(const std::filesystem::path& directory, const results::Run& run,
                       const std::string& json) {
  const base::ProcessExitBlocker in_hand;
  base::FileTransaction files;
  results::add_summary_and_curves(files, directory, run);
  files.add(directory / "check.json", json + '\n');
  files.commit();
  set_exit_message("all files were written");
}

}  // namespace

int check_command(const CommandInvocation& call) {
  const base::Stopwatch stopwatch;
  namespace po = boost::program_options;
  CommonCommandArguments common;
  check::BaselineCheckTolerances tolerances;
  int threads = 0;
  std::vector<std::string> paths;
  po::options_description own;
  own.add_options()  //
      ("tolerance",
       po::value(&tolerances.deterministic)
           ->value_name("T")
           ->default_value(tolerances.deterministic, "1e-08"),
       "tolerance for moments (relative), densities and distances of deterministic methods; 50 "
       "times as large for coefficients, 100 times for distances in tails")  //
      ("standard-errors",
       po::value(&tolerances.standard_errors)
           ->value_name("N")
           ->default_value(tolerances.standard_errors),
       "tolerance for simulations, in standard errors of the difference of both runs")  //
      ("threads", po::value(&threads)->value_name("N"),
       "number of threads (default: one per processor)");
  const auto options = add_output_options(
      own, common,
      "write check.json, and summary.json and marginals.csv of the new run, to DIR (default: no "
      "files)");
  if (!parse_arguments(call.arguments, kCheckUsage, options, paths)) return kSuccess;
  if (paths.size() != 1) {
    throw InputError("check takes one baseline; name the summary.json of a run or its directory");
  }
  check::validate(tolerances);
  if (threads < 0) throw InputError(fmt::format("--threads {} (must not be negative)", threads));
  using base::Value;
  const auto baseline =
      check::load_baseline(paths.front(), call.registry,
                           {{"threads", threads > 0 ? Value(std::int64_t{threads}) : Value()}});
  const OutputDirectory directory(common.out);

  ProgressLine progress(common.quiet);
  const auto run = check::repeat_baseline_run(
      baseline, call.command_line, threads,
      [&](const methods::RunProgress& at) { progress.show_progress(at); });
  throw_if_interrupted();
  progress.erase_line();

  auto result = check::compare_runs(baseline.run, run, tolerances, baseline.has_marginals);
  result.notes = baseline.notes;
  const auto json = check::check_result_json(result, call.command_line, paths.front());
  if (common.json) {
    print_output(json + '\n');
  } else if (!common.quiet) {
    print_output(check::check_result_table(result, terminal_format()));
  }
  if (common.out) write_check_files(*common.out, run, json);
  if (!common.quiet && !common.json) {
    print_output(fmt::format(
        "{}{:.1f} s.\n",
        common.out
            ? fmt::format("Wrote check.json, summary.json and marginals.csv to {} in ", *common.out)
            : "Done in ",
        stopwatch.seconds()));
  }
  if (common.quiet && !result.agrees_with_baseline()) {
    print_message(fmt::format("{} of {} quantities changed",
                              result.quantities_beyond_tolerance().size(), result.changes.size()));
  }
  return result.agrees_with_baseline() ? kSuccess : kFailure;
}

namespace {

constexpr const char* kReportUsage = R"(usage: fpkcheck report DIR [options]

Prints the table of a saved run and rebuilds its report.html and figures; for a run of `paper` also
the claims and the figures of the paper. DIR is the directory of the run. Solves nothing.
)";

}  // namespace

int report_command(const CommandInvocation& call) {
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
  call.registry.set_missing_identity_fields_of_run(run);
  std::vector<transform::SolutionIdentity> identities;
  for (const auto& case_result : run.cases) {
    for (const auto& solution : case_result.solutions) identities.push_back(solution.identity);
  }
  report::require_requested_curves_exist(figures.curves, identities);
  const base::ProcessExitBlocker in_hand;
  const auto format = terminal_format();
  const auto supplement =
      paper::is_paper_run(run)
          ? paper::claims_supplement(paper::judge_claims(run), run, figures.width, format)
          : report::ReportSupplement{};
  const auto [text, warnings] =
      report::rebuild_report(directories.front(), run, format, figures, supplement);
  set_exit_message("report.html was written, but not all figures");
  if (!quiet) print_output(text);
  for (const auto& warning : warnings) print_message(warning);
  return kSuccess;
}

}  // namespace fpkcheck::cli
