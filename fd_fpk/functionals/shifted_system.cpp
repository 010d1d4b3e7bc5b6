#include "fd_fpk/functionals/shifted_system.hpp"

#include "fd_fpk/linear/gmres.hpp"

namespace fpkcheck::fd_fpk {

std::string ShiftedLinearSystem::large_factors_reason(Eigen::Index size, int nv, int order) {
  // Largest number of elements of the factors, 400 MB. With factors `fpkcheck spectrum case1
  // --methods fd-kf` takes 3.6 s instead of 6.6 s.
  constexpr double kMostElements = 5e7;
  // One-sided stencils at a wall reach order - 1 cells; all other stencils reach about half as many
  // cells.
  const int reach = (order + 2) / 2;
  const double elements =
      numerics::BlockBandedLu::factor_element_count(static_cast<double>(size), nv, reach);
  return elements <= kMostElements
             ? ""
             : "the factors of the matrix need too much memory; use fewer cells";
}

ShiftedLinearSystem::ShiftedLinearSystem(const FokkerPlanckOperator& op,
                                         Preconditioner* preconditioner, int nv, int order,
                                         double shift, OperatorTransposition transposed)
    : op_(op), preconditioner_(preconditioner), shift_(shift), transposed_(transposed) {
  failure_ = large_factors_reason(op.areas.size(), nv, order);
  if (failure_.empty()) {
    factors_.emplace(scale_and_shift_matrix(-1, op.assembled_matrix(), shift), nv);
    if (factors_->is_finite()) return;
    factors_.reset();
    failure_ = "the factors of the matrix are not finite; use other cells";
  }
  if (preconditioner == nullptr) return;
  failure_ =
      preconditioner->factorise_newton_matrix(1 / shift) ? "" : preconditioner->failure_reason();
}

std::optional<Eigen::VectorXd> ShiftedLinearSystem::solve(const Eigen::VectorXd& right_hand_side,
                                                          double tolerance,
                                                          const base::Deadline& deadline,
                                                          std::string& failure) const {
  const bool is_transposed = transposed_ == OperatorTransposition::yes;
  if (factors_) {
    if (deadline.has_deadline_passed()) {
      failure = "max_seconds expired; increase max-seconds or use fewer cells";
      return std::nullopt;
    }
    Eigen::VectorXd x = right_hand_side;
    is_transposed ? factors_->solve_transposed_in_place(x) : factors_->solve_in_place(x);
    return x;
  }
  if (!failure_.empty()) {
    failure = failure_;
    return std::nullopt;
  }
  const auto times = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return x - (is_transposed ? op_.transposed_product(x) : op_ * x) / shift_;
  };
  const auto approximate_solve = [&](Eigen::Ref<Eigen::VectorXd> x) {
    is_transposed ? preconditioner_->solve_transposed_in_place(x)
                  : preconditioner_->solve_in_place(x);
  };
  const Eigen::VectorXd weights = is_transposed ? op_.areas.cwiseInverse() : op_.areas;
  auto [solution, iterations, reason] = solve_by_gmres(
      times, approximate_solve, right_hand_side / shift_, weights, tolerance, deadline);
  if (!solution) failure = reason;
  return std::move(solution);
}

}  // namespace fpkcheck::fd_fpk
