#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "numerics/linear_algebra/block_banded_lu.hpp"

namespace fpkcheck::fd_fpk {

enum class OperatorTransposition { no, yes };

/// Linear systems (s - L) x = b of an operator L with a shift s > 0, or of the transposed operator.
/// The system is solved for many right-hand sides. If memory permits, the constructor therefore
/// factors the whole matrix, including the jumps, in dense blocks for the cells at one x1.
/// Otherwise GMRES solves each system.
class ShiftedLinearSystem {
 public:
  /// @param op,preconditioner must outlive this object
  /// @param preconditioner preconditioner of GMRES; null if only the factors solve the systems
  /// @param nv number of cells of x2
  /// @param order order of the scheme
  ShiftedLinearSystem(const FokkerPlanckOperator& op, Preconditioner* preconditioner, int nv,
                      int order, double shift,
                      OperatorTransposition transposed = OperatorTransposition::no);

  /// Returns why the factors of a matrix would need too much memory; empty if the constructor
  /// factors the matrix.
  /// @param size number of rows of the matrix
  static std::string large_factors_reason(Eigen::Index size, int nv, int order);

  double resolvent_shift() const { return shift_; }
  const FokkerPlanckOperator& operator_without_shift() const { return op_; }
  /// Returns the factors of s - L; null if GMRES solves the systems.
  const numerics::BlockBandedLu* direct_matrix_factors() const {
    return factors_ ? &*factors_ : nullptr;
  }

  /// @param tolerance relative residual of GMRES
  /// @return the solution; empty with a reason in `failure`
  std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& right_hand_side, double tolerance,
                                       const base::Deadline& deadline, std::string& failure) const;

 private:
  const FokkerPlanckOperator& op_;
  const Preconditioner* preconditioner_;
  double shift_;
  OperatorTransposition transposed_;
  std::optional<numerics::BlockBandedLu> factors_ = {};
  std::string failure_ = {};  // reason why the preconditioner could not be factored
};

}  // namespace fpkcheck::fd_fpk
