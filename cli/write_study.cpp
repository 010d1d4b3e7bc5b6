#include "cli/write_study.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/files/pending_files.hpp"
#include "base/input_error.hpp"
#include "base/process/exit_blocker.hpp"
#include "cli/program.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/standard_streams.hpp"
#include "report/figure/drawing.hpp"

namespace fpkcheck::cli {
namespace {

void write_files(const std::filesystem::path& directory, const study::StudyOutput& output,
                 const report::FigureOptions& options) {
  const base::ExitBlocker in_hand;
  base::PendingFiles files;
  files.add(directory / (output.stem + ".json"), output.json + '\n');
  files.add(directory / (output.stem + ".csv"), output.csv);
  files.commit();
  set_exit_message("all files were written except the figure");
  if (output.figure.empty()) return;
  report::remove_script_and_pictures(directory / "figures", output.stem);
  for (const auto& warning : report::write_pictures(directory / "figures", output.stem,
                                                    output.figure, options, "gnuplot")) {
    print_message(warning);
  }
}

std::string written_files_text(const study::StudyOutput& output,
                               const report::FigureOptions& options) {
  std::string files = fmt::format("{}.json", output.stem);
  if (output.figure.empty()) return files + " and .csv";
  return files +
         fmt::format(", .csv and figures/{}.{}", output.stem, name(options.formats.front()));
}

}  // namespace

void write_study(const CommonArguments& common, const study::StudyOutput& output,
                 std::chrono::steady_clock::time_point start_time) {
  if (common.json) {
    print_output(output.json + '\n');
  } else if (!common.quiet) {
    print_output(output.table);
  }
  if (common.out) write_files(*common.out, output, common.figures);
  if (common.quiet || common.json) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_time;
  print_output(
      fmt::format("\n{}{:.1f} s.\n",
                  common.out ? fmt::format("Wrote {} to {} in ",
                                           written_files_text(output, common.figures), *common.out)
                             : "Done in ",
                  elapsed.count()));
}

int study_exit_code(const CommonArguments& common, bool is_converged) {
  if (is_converged) return kSuccess;
  if (common.quiet)
    print_message(
        "the study did not meet the criterion that --help states; see the table of the study");
  return kFailure;
}

StudySetup prepare_study(const CommonArguments& common) {
  auto problems = load_cases(common);
  if (problems.size() != 1) throw InputError("a study takes one case; name it, e.g. case1");
  return {std::move(problems.front()), OutputDirectory(common.out)};
}

}  // namespace fpkcheck::cli
