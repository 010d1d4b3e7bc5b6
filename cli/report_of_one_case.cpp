#include "cli/report_of_one_case.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/files/file_transaction.hpp"
#include "report/figure/run_gnuplot.hpp"

namespace fpkcheck::cli {
namespace {

void write_study_files(const std::filesystem::path& directory, const study::StudyReport& output,
                       const report::FigureOptions& options) {
  const base::ProcessExitBlocker in_hand;
  base::FileTransaction files;
  files.add(directory / (output.file_stem + ".json"), output.json + '\n');
  files.add(directory / (output.file_stem + ".csv"), output.csv);
  if (!output.netcdf.empty()) files.add(directory / (output.file_stem + ".nc"), output.netcdf);
  if (!output.page.empty()) files.add(directory / (output.file_stem + ".html"), output.page);
  files.commit();
  set_exit_message("all files were written except the figure");
  if (output.figure_script.empty()) return;
  report::remove_script_and_pictures(directory / "figures", output.file_stem);
  for (const auto& warning : report::write_script_and_draw(
           directory / "figures", output.file_stem, output.figure_script, options, "gnuplot")) {
    print_message(warning);
  }
}

}  // namespace

void OneCaseReportCommand::write_output_files(const study::StudyReport& output) const {
  if (common.json) {
    print_output(output.json + '\n');
  } else if (!common.quiet) {
    print_output(output.text);
  }
  if (common.out) write_study_files(*common.out, output, common.figures);
  if (common.quiet || common.json) return;
  const std::string figure = output.figure_script.empty()
                                 ? " and .csv"
                                 : fmt::format(", .csv and figures/{}.{}", output.file_stem,
                                               name(common.figures.formats.front()));
  print_output(fmt::format(
      "\n{}{:.1f} s.\n",
      common.out ? fmt::format("Wrote {}.json{}{}{} to {} in ", output.file_stem,
                               output.netcdf.empty() ? "" : ", .nc",
                               output.page.empty() ? "" : ", .html", figure, *common.out)
                 : "Done in ",
      stopwatch_.seconds()));
}

}  // namespace fpkcheck::cli
