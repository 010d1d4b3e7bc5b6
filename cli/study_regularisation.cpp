#include <chrono>

#include "cli/command_line.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/put_study.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/studies.hpp"
#include "workflows/study/regularisation.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kRegularisationUsage = R"(usage: fpkcheck study regularisation CASE [options]

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

}  // namespace

int study_regularisation(const Call& call) {
  const auto begin = std::chrono::steady_clock::now();
  CommonArguments common;
  if (!parse(call.arguments, kRegularisationUsage,
             with_common_options({}, common, "write study-regularisation.json and .csv there"),
             common.cases)) {
    return kDone;
  }
  const auto start = start_of_study(common);
  ProgressLine line(common.quiet);
  const auto found = study::study_regularisation(
      start.problem, [&](const methods::RunProgress& at) { line.show(at); });
  throw_if_interrupted();
  line.clear();
  put_study(common, study::output(found, call.command_line, terminal_format()), begin);
  return exit_code_of_study(common, study::has_converged(found));
}

}  // namespace fpkcheck::cli
