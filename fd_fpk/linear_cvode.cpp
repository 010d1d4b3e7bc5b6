#include "fd_fpk/linear_cvode.hpp"

namespace fpkcheck::fd_fpk {

using namespace sundials_owned;

int LinearCvode::right_hand_side(realtype, N_Vector p, N_Vector p_dot, void* data) {
  view(p_dot) = static_cast<Callbacks*>(data)->op * view(p);
  return 0;
}

int LinearCvode::times(N_Vector v, N_Vector lv, realtype, N_Vector, N_Vector, void* data,
                       N_Vector) {
  view(lv) = static_cast<Callbacks*>(data)->op * view(v);
  return 0;
}

int LinearCvode::factor(realtype, N_Vector, N_Vector, booleantype, booleantype* current,
                        realtype gamma, void* data) {
  *current = SUNTRUE;
  return static_cast<Callbacks*>(data)->preconditioner.factor(gamma) ? 0 : -1;
}

int LinearCvode::precondition(realtype, N_Vector, N_Vector, N_Vector r, N_Vector z, realtype,
                              realtype, int, void* data) {
  view(z) = view(r);
  static_cast<Callbacks*>(data)->preconditioner.solve_in_place(view(z));
  return 0;
}

void LinearCvode::keep_message(int, const char*, const char* function, char* text, void* data) {
  static_cast<Callbacks*>(data)->message = fmt::format("{}: {}", function, text);
}

LinearCvode::LinearCvode(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                         const Eigen::VectorXd& start, const BdfControl& control)
    : callbacks_(new Callbacks{op, preconditioner, ""}),
      averages_(vector_of(start, context_)),
      gmres_(
          owned(SUNLinSol_SPGMR(averages_.get(), SUN_PREC_RIGHT, 100, context_), "a GMRES solver")),
      cvode_(owned(CVodeCreate(CV_BDF, context_), "CVODE")) {
  check(CVodeInit(get(), right_hand_side, 0.0, averages_.get()), "CVodeInit");
  check(CVodeSetErrHandlerFn(get(), keep_message, callbacks_.get()), "CVodeSetErrHandlerFn");
  check(CVodeSetUserData(get(), callbacks_.get()), "CVodeSetUserData");
  check(CVodeSStolerances(get(), control.relative_tolerance, control.absolute_tolerance),
        "CVodeSStolerances");
  check(CVodeSetMaxOrd(get(), control.max_order), "CVodeSetMaxOrd");
  check(CVodeSetLinearSolver(get(), gmres_.get(), nullptr), "CVodeSetLinearSolver");
  check(CVodeSetJacTimes(get(), nullptr, times), "CVodeSetJacTimes");
  check(CVodeSetPreconditioner(get(), factor, precondition), "CVodeSetPreconditioner");
  check(CVodeSetEpsLin(get(), control.linear_tolerance), "CVodeSetEpsLin");
}

int LinearCvode::advance(double time, int task, double& reached) {
  return CVode(get(), time, averages_.get(), &reached, task);
}

long LinearCvode::steps() const {
  long count = 0;
  check(CVodeGetNumSteps(get(), &count), "CVodeGetNumSteps");
  return count;
}

long LinearCvode::factorisations() const {
  long count = 0;
  check(CVodeGetNumPrecEvals(get(), &count), "CVodeGetNumPrecEvals");
  return count;
}

long LinearCvode::rhs_evaluations() const {
  long count = 0;
  check(CVodeGetNumRhsEvals(get(), &count), "CVodeGetNumRhsEvals");
  return count;
}

long LinearCvode::krylov_iterations() const {
  long count = 0;
  check(CVodeGetNumLinIters(get(), &count), "CVodeGetNumLinIters");
  return count;
}

}  // namespace fpkcheck::fd_fpk
