#include <chrono>

#include "cli/command_line.hpp"
#include "cli/interruption.hpp"
#include "cli/program.hpp"
#include "cli/progress_line.hpp"
#include "cli/solve_and_report.hpp"
#include "cli/study_subjects.hpp"
#include "cli/write_study.hpp"
#include "workflows/study/regularisation.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kRegularisationUsage = R"(usage: fpkcheck study regularisation CASE [options]

The series truncated after the fourth derivative, discretised with decreasing velocity steps h:
  literal      fourth difference over the step, l = h: ill-posed, growth rates increase as h falls
  0.9 l*       fixed length below the threshold l* of well-posedness
  1.1 l*       fixed length above the threshold
  regularised  the default length, l^2 = E[Y^6] / (5 E[Y^4])
  pade         the Pade approximant of the series, which has no length
Each row has the largest growth rate of a wave (from the symbol), the rightmost eigenvalue of the
matrix (shift-invert Arnoldi with KLU factors), and the distance of the null vector from the density
of the full jump equation on the same grid.
Exit code 0 when the default length has no growth and gives a density at the smallest step.

examples:
  fpkcheck study regularisation case1
  fpkcheck study regularisation mine.ini --set system.restitution=0.9 --out results
)";

}  // namespace

int study_regularisation(const CommandCall& call) {
  const auto begin = std::chrono::steady_clock::now();
  CommonArguments common;
  if (!parse_arguments(
          call.arguments, kRegularisationUsage,
          add_common_options({}, common,
                             "write study-regularisation.json and .csv to DIR (default: no files)"),
          common.cases)) {
    return kSuccess;
  }
  const auto setup = prepare_study(common);
  ProgressLine line(common.quiet);
  const auto result = study::study_regularisation(
      setup.problem, [&](const methods::RunProgress& at) { line.rewrite(at); });
  throw_if_interrupted();
  line.erase();
  write_study(common, study::output(result, call.command_line, terminal_format()), begin);
  return study_exit_code(common, study::has_converged(result));
}

}  // namespace fpkcheck::cli
