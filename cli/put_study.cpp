#include "cli/put_study.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "cli/solve_and_report.hpp"
#include "compare/figure/drawing.hpp"
#include "compare/report.hpp"
#include "compare/run_directory.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {
namespace {

void write(const std::filesystem::path& directory, const StudyOutput& study) {
  compare::PendingFiles files;
  files.add(directory / (study.stem + ".json"), compare::json_text(study.report) + '\n');
  files.add(directory / (study.stem + ".csv"), study.csv);
  files.commit();
  if (study.figure.empty()) return;
  compare::remove_pictures_of(directory / "figures", study.stem);
  for (const auto& warning :
       compare::write_pictures(directory / "figures", study.stem, study.figure, "gnuplot")) {
    fmt::print(stderr, "fpkcheck: {}\n", warning);
  }
}

std::string files_of(const StudyOutput& study) {
  return study.figure.empty() ? fmt::format("{}.json and .csv", study.stem)
                              : fmt::format("{0}.json, .csv and figures/{0}.png", study.stem);
}

}  // namespace

void put_study(const CommonArguments& common, const StudyOutput& study,
               std::chrono::steady_clock::time_point begin) {
  if (common.json) {
    fmt::print("{}\n", compare::json_text(study.report));
  } else if (!common.quiet) {
    fmt::print("{}", study.table);
    std::fflush(stdout);
  }
  if (common.out) write(*common.out, study);
  if (common.quiet || common.json) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  fmt::print(
      "\n{}{:.1f} s.\n",
      common.out ? fmt::format("Wrote {} to {} in ", files_of(study), *common.out) : "Done in ",
      elapsed.count());
}

StudyStart start_of_study(const CommonArguments& common) {
  auto problems = load_cases(common);
  if (problems.size() != 1) throw InputError("a study takes one case");
  compare::MadeDirectories made;
  if (common.out) made = compare::make_writable(*common.out);
  return {std::move(problems.front()), std::move(made)};
}

}  // namespace fpkcheck::cli
