#include "fd_fpk/null_vector.hpp"

#include "fd_fpk/gmres.hpp"

namespace fpkcheck::fd_fpk {

NullVector null_vector(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                       const Eigen::VectorXd& start) {
  constexpr double kTolerance = 1e-13;
  if (!preconditioner.factor_stationary()) return {std::nullopt, 0, preconditioner.failure()};
  const auto times = [&](const Eigen::VectorXd& p) { return op * p; };
  const auto nearby = [&](Eigen::Ref<Eigen::VectorXd> b) { preconditioner.solve_in_place(b); };
  auto [correction, iterations, failure] =
      gmres(times, nearby, -(op * start), op.areas, kTolerance);
  if (!correction) return {std::nullopt, iterations, failure + " (take another grid)"};
  Eigen::VectorXd averages = start + *correction;
  averages /= op.mass(averages);
  return {std::move(averages), iterations};
}

}  // namespace fpkcheck::fd_fpk
