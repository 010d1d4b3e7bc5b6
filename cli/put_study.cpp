#include "cli/put_study.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "cli/solve_and_report.hpp"
#include "files/pending_files.hpp"
#include "parameters/input_error.hpp"
#include "parameters/shown.hpp"
#include "report/figure/drawing.hpp"

namespace fpkcheck::cli {
namespace {

void write(const std::filesystem::path& directory, const study::Output& output) {
  files::PendingFiles files;
  files.add(directory / (output.stem + ".json"), output.json + '\n');
  files.add(directory / (output.stem + ".csv"), output.csv);
  files.commit();
  if (output.figure.empty()) return;
  report::remove_pictures_of(directory / "figures", output.stem);
  for (const auto& warning :
       report::write_pictures(directory / "figures", output.stem, output.figure, "gnuplot")) {
    fmt::print(stderr, "fpkcheck: {}\n", parameters::one_line(warning));
  }
}

std::string files_of(const study::Output& output) {
  return output.figure.empty() ? fmt::format("{}.json and .csv", output.stem)
                               : fmt::format("{0}.json, .csv and figures/{0}.png", output.stem);
}

}  // namespace

void put_study(const CommonArguments& common, const study::Output& output,
               std::chrono::steady_clock::time_point begin) {
  if (common.json) {
    fmt::print("{}\n", output.json);
  } else if (!common.quiet) {
    fmt::print("{}", output.table);
    std::fflush(stdout);
  }
  if (common.out) write(*common.out, output);
  if (common.quiet || common.json) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  fmt::print(
      "\n{}{:.1f} s.\n",
      common.out ? fmt::format("Wrote {} to {} in ", files_of(output), *common.out) : "Done in ",
      elapsed.count());
}

StudyStart start_of_study(const CommonArguments& common) {
  auto problems = load_cases(common);
  if (problems.size() != 1) throw InputError("a study takes one case");
  results::MadeDirectories made;
  if (common.out) made = results::make_writable(*common.out);
  return {std::move(problems.front()), std::move(made)};
}

}  // namespace fpkcheck::cli
