#include "fd_fpk/stationary/pseudo_transient.hpp"

#include <fmt/format.h>

#include <utility>

#include "fd_fpk/linear/linear_cvode.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

namespace {
struct OutOfTime {};
}  // namespace

March march_to_stationarity(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                            const Eigen::VectorXd& start, double tolerance,
                            const TimeScales& scales, const Deadline& deadline) {
  constexpr long kMaxSteps = 200;
  // Local errors are no aim here: a step may change the density by as much as itself.
  constexpr double kRelativeTolerance = 1;
  const double absolute_tolerance = start.maxCoeff();
  // Errors count by their mass. Narrow cells at a singularity hold next to none, and would shorten
  // the steps by what their density does on the way: white noise at r = 0.6 took 860 iterations of
  // GMRES for 372.
  const Eigen::VectorXd absolute_tolerances =
      absolute_tolerance * op.areas.mean() / op.areas.array();
  // The residual of the last step's linear system is what remains of L P: they are solved far below
  // the error test.
  constexpr double kLinearTolerance = 1e-11;
  constexpr double kStepGrowth = 100;

  const Stopwatch stopwatch;
  const double factored_before = preconditioner.factor_seconds();
  LinearSystem system = linear_system(op, preconditioner);
  // One step may take as long as many products.
  system.times = [&deadline, times = std::move(system.times)](const Eigen::VectorXd& p) {
    if (deadline.is_over()) throw OutOfTime();
    return times(p);
  };
  LinearCvode cvode(std::move(system), start,
                    {.max_order = 1,
                     .relative_tolerance = kRelativeTolerance,
                     .absolute_tolerance = absolute_tolerance,
                     .linear_tolerance = kLinearTolerance,
                     .absolute_tolerances = absolute_tolerances,
                     .first_step = scales.first_step,
                     .longest_step = scales.longest_step,
                     .step_growth = kStepGrowth});
  March march;
  march.residual = op.residual(start);
  while (march.residual > tolerance && march.steps < kMaxSteps) {
    const Stopwatch of_step;
    int flag = 0;
    try {
      flag = cvode.step().flag;
    } catch (const OutOfTime&) {
      march.out_of_time = true;
      break;
    }
    march.steps = cvode.steps();
    if (flag < 0) {
      march.reason =
          fmt::format("CVODE stopped at step {} (flag {}): {}", march.steps, flag, cvode.message());
      break;
    }
    march.residual = op.residual(cvode.averages());
    if (march.residual > tolerance && !deadline.allows(of_step.seconds())) {
      march.out_of_time = true;
      break;
    }
  }
  march.factorisations = cvode.factorisations();
  march.rhs_evaluations = cvode.rhs_evaluations();
  march.krylov_iterations = cvode.krylov_iterations();
  march.factor_seconds = preconditioner.factor_seconds() - factored_before;
  march.krylov_seconds = stopwatch.seconds() - march.factor_seconds;
  march.averages = cvode.averages();
  return march;
}

}  // namespace fpkcheck::fd_fpk
