#include "fd_fpk/stationary/pseudo_transient.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fd_fpk/linear/linear_cvode.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

PseudoTransientResult march_to_stationarity(const FokkerPlanckOperator& op,
                                            Preconditioner& preconditioner,
                                            const Eigen::VectorXd& start, double tolerance,
                                            double decay_time, const Deadline& deadline) {
  constexpr long kMaxSteps = 200;
  // Limits of the time step, in decay times. The upper limit is necessary because rounding errors
  // in (I - gamma L)^-1 displace mass by about 1e-15 gamma ||L||.
  constexpr double kFirstStep = 10, kLongestStep = 500;
  // Tolerances with which CVODE does not limit steps by local errors: a step may change the density
  // by many times its own size.
  constexpr double kRelativeTolerance = 1, kPeakMultiple = 1000;
  const double absolute_tolerance = kPeakMultiple * start.maxCoeff();
  // Tolerances refer to the mass of a cell. Tolerances for densities would shorten the steps,
  // because the density varies strongly in the narrow cells at a singularity, whose mass is
  // negligible: for white noise at r = 0.6 GMRES took 860 iterations instead of 372.
  const Eigen::VectorXd absolute_tolerances =
      absolute_tolerance * op.areas.mean() / op.areas.array();
  // The residual of GMRES in a step, relative to the peak, is gamma times the contribution of this
  // residual to L P. The tolerance is a hundredth of the residual expected from the step, about
  // 1/gamma of the preceding residual in decay times. The residual of the last step remains in the
  // solution.
  constexpr double kPart = 1e-2, kLastStepTolerance = 1e-11;
  const auto linear_tolerance = [&](double residual) {
    const bool is_last = residual <= kLongestStep * tolerance;
    const double part = is_last
                            ? kLastStepTolerance
                            : std::clamp(kPart * residual * decay_time, kLastStepTolerance, kPart);
    return part / kPeakMultiple;
  };
  constexpr double kStepGrowth = 100;

  const Stopwatch stopwatch;
  const double factored_before = preconditioner.factor_seconds();
  PseudoTransientResult march;
  march.residual = op.stationarity_residual(start);
  LinearCvode cvode(with_deadline(deadline, linear_ode_system(op, preconditioner)), start,
                    {.max_order = 1,
                     .relative_tolerance = kRelativeTolerance,
                     .absolute_tolerance = absolute_tolerance,
                     .linear_tolerance = linear_tolerance(march.residual),
                     .absolute_tolerances = absolute_tolerances,
                     .first_step = kFirstStep * decay_time,
                     .max_step = kLongestStep * decay_time,
                     .step_growth = kStepGrowth});
  while (march.residual > tolerance && march.steps < kMaxSteps) {
    const Stopwatch of_step;
    cvode.set_linear_tolerance(linear_tolerance(march.residual));
    int flag = 0;
    try {
      flag = cvode.take_step().flag;
    } catch (const DeadlineExceeded&) {
      march.out_of_time = true;
      break;
    }
    march.steps = cvode.step_count();
    if (flag < 0) {
      march.reason = fmt::format("CVODE failed at step {} (flag {}): {}", march.steps, flag,
                                 cvode.error_message());
      break;
    }
    march.residual = op.stationarity_residual(cvode.averages());
    if (march.residual > tolerance && !deadline.has_time_for(of_step.seconds())) {
      march.out_of_time = true;
      break;
    }
  }
  march.rhs_evaluations = cvode.rhs_evaluation_count();
  march.krylov_iterations = cvode.krylov_iteration_count();
  march.krylov_seconds = stopwatch.seconds() - (preconditioner.factor_seconds() - factored_before);
  // The density is normalised to mass 1 again, because the residual of GMRES changes the mass.
  march.averages = cvode.averages() / op.total_mass(cvode.averages());
  return march;
}

}  // namespace fpkcheck::fd_fpk
