#include <chrono>

#include "cli/command_line.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/put_study.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/studies.hpp"
#include "compare/report.hpp"
#include "compare/run_directory.hpp"
#include "compare/study/regularisation.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kUsage = R"(usage: fpkcheck study regularisation CASE [options]

What becomes of the series cut after the fourth derivative on finer and finer velocity steps h:
  literal      fourth difference over the step, l = h: ill-posed, the worse the finer
  0.9 l*       a fixed length below the threshold l* of well-posedness, and
  1.1 l*       one above it
  regularised  the default length, l^2 = E[Y^6] / (5 E[Y^4])
  pade         the Pade approximant of the series, which has no length
Each row gives the largest growth rate of a wave (from the symbol), the rightmost eigenvalue of the
whole matrix (shift-invert Arnoldi on KLU factors), and how far the null vector is from the density
of the full jump equation on the same grid.
Exit code 0 when the default length neither grows nor lacks a density on the finest step.

examples:
  fpkcheck study regularisation case1
  fpkcheck study regularisation mine.ini --set system.restitution=0.9 --out results
)";

bool reached(const fd_fpk::RegularisationStudy& study, const problem::Problem& problem) {
  const fd_fpk::RegularisationRow* finest = nullptr;
  for (const auto& row : study.rows) {
    if (row.scheme == "regularised") finest = &row;
  }
  return finest != nullptr && !finest->growth(problem) && finest->l1_y;
}

int study(const CommonArguments& common, const std::string& command_line) {
  const auto begin = std::chrono::steady_clock::now();
  const auto start = start_of_study(common);
  const auto& problem = start.problem;

  const InterruptionGuard guard;
  ProgressLine line(common.quiet);
  const auto study = fd_fpk::study_regularisation(problem, {}, [&](int row, int rows) {
    line.show({.done = static_cast<std::size_t>(row),
               .total = static_cast<std::size_t>(rows),
               .case_name = problem.name,
               .method = "regularisation",
               .fraction = 0});
  });
  throw_if_interrupted();
  line.clear();

  const auto report = compare::regularisation_report(command_line, problem, study);
  put_study(common,
            {.stem = "study-regularisation",
             .report = report,
             .table = compare::regularisation_table(report, terminal_format()),
             .csv = compare::regularisation_csv(report)},
            begin);
  return reached(study, problem) ? kDone : kNotReached;
}

}  // namespace

int study_regularisation(const std::vector<std::string>& arguments,
                         const std::string& command_line) {
  CommonArguments common;
  if (!parse(arguments, kUsage,
             with_common_options({}, common, "write study-regularisation.json and .csv there"),
             common.cases)) {
    return kDone;
  }
  return study(common, command_line);
}

}  // namespace fpkcheck::cli
