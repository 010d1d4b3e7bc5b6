#pragma once

#include "fd_fpk/operator.hpp"
#include "fd_fpk/preconditioner.hpp"
#include "fd_fpk/sundials.hpp"

namespace fpkcheck::fd_fpk {

/// How CVODE steps.
struct BdfControl {
  int max_order;  ///< of BDF, 1 .. 5; above 2 it is not stable on the whole imaginary axis
  double relative_tolerance;  ///< of the local error of a cell's average, in the RMS over the cells
  double absolute_tolerance;  ///< likewise, in units of the density
  double linear_tolerance;    ///< of GMRES, as a fraction of the local error
};

/// CVODE, BDF, on dP/dt = L P: GMRES with L itself, preconditioned by KLU factors of a sparse
/// operator close to I - gamma L.
class LinearCvode {
 public:
  /// @param op,preconditioner must outlive this object
  /// @throws std::runtime_error when SUNDIALS cannot be set up
  LinearCvode(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
              const Eigen::VectorXd& start, const BdfControl& control);

  void* get() const { return cvode_.get(); }
  /// One internal step (CV_ONE_STEP) or on to `time` (CV_NORMAL).
  /// @return CVODE's flag; negative: it stopped, see message()
  int advance(double time, int task, double& reached);
  Eigen::Map<Eigen::VectorXd> averages() const { return sundials_owned::view(averages_.get()); }
  const std::string& message() const { return callbacks_->message; }

  /// Counts of CVODE since the start.
  long steps() const;
  long factorisations() const;
  long rhs_evaluations() const;
  long krylov_iterations() const;

 private:
  struct Callbacks {
    const FokkerPlanckOperator& op;
    Preconditioner& preconditioner;
    std::string message;
  };
  static int right_hand_side(realtype, N_Vector p, N_Vector p_dot, void* data);
  static int times(N_Vector v, N_Vector lv, realtype, N_Vector, N_Vector, void* data, N_Vector);
  static int factor(realtype, N_Vector, N_Vector, booleantype, booleantype* current, realtype gamma,
                    void* data);
  static int precondition(realtype, N_Vector, N_Vector, N_Vector r, N_Vector z, realtype, realtype,
                          int, void* data);
  static void keep_message(int, const char*, const char* function, char* text, void* data);

  sundials::Context context_;
  std::unique_ptr<Callbacks> callbacks_;
  sundials_owned::Owned<N_Vector> averages_;
  sundials_owned::Owned<SUNLinearSolver> gmres_;
  sundials_owned::Owned<void*> cvode_;
};

}  // namespace fpkcheck::fd_fpk
