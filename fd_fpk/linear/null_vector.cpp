#include "fd_fpk/linear/null_vector.hpp"

#include <fmt/format.h>

#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/linear/klu.hpp"
#include "fd_fpk/stopwatch.hpp"

namespace fpkcheck::fd_fpk {

NullVector null_vector(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                       const Eigen::VectorXd& start, const Deadline& deadline) {
  constexpr double kTolerance = 1e-13;
  if (!preconditioner.factor_stationary())
    return {std::nullopt, 0, preconditioner.failure_reason()};
  const auto times = [&](const Eigen::VectorXd& p) { return op * p; };
  const auto approximate_solve = [&](Eigen::Ref<Eigen::VectorXd> b) {
    preconditioner.solve_in_place(b);
  };
  const Stopwatch stopwatch;
  auto [correction, iterations, failure] =
      gmres(times, approximate_solve, -(op * start), op.areas, kTolerance, deadline);
  const double seconds = stopwatch.seconds();
  if (!correction) return {std::nullopt, iterations, failure + "; use another grid", seconds};
  Eigen::VectorXd averages = start + *correction;
  averages /= op.total_mass(averages);
  return {std::move(averages), iterations, "", seconds};
}

NullVector null_vector_by_inverse_iteration(const FokkerPlanckOperator& op,
                                            const Eigen::VectorXd& start, double frequency) {
  constexpr double kShift = 1e-7;  // shift that makes the matrix regular, in units of the frequency
  constexpr int kIterations = 4;
  constexpr double kResidual = 1e-8;
  KluFactorisation klu;
  if (!klu.factorise(scale_and_shift(1, op.assembled_matrix(), -kShift * frequency)))
    return {std::nullopt, 0, klu.failure_reason()};
  Eigen::VectorXd averages = start;
  for (int k = 0; k < kIterations; ++k) {
    klu.solve_in_place(averages);
    averages /= op.total_mass(averages);
  }
  const double residual = op.stationarity_residual(averages) / frequency;
  if (!(residual < kResidual)) {
    return {std::nullopt, 0,
            fmt::format("inverse iteration did not converge: residual {:.1e}", residual)};
  }
  return {std::move(averages), 0};
}

}  // namespace fpkcheck::fd_fpk
