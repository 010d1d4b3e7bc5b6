#include "fd_fpk/pseudo_transient.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <sundials/sundials_context.hpp>

#include "fd_fpk/null_vector.hpp"

namespace fpkcheck::fd_fpk {
namespace {

static_assert(sizeof(sunindextype) == sizeof(SparseColumns::StorageIndex));

struct Destroy {
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
  void operator()(void* cvode) const { CVodeFree(&cvode); }
};
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Destroy>;

Eigen::Map<Eigen::VectorXd> view(N_Vector v) {
  return {N_VGetArrayPointer(v), static_cast<Eigen::Index>(N_VGetLength(v))};
}

// What the callbacks need, and CVODE's last message.
struct Callback {
  const SparseColumns* matrix;
  std::string message;
};

int right_hand_side(realtype, N_Vector p, N_Vector p_dot, void* data) {
  view(p_dot) = *static_cast<Callback*>(data)->matrix * view(p);
  return 0;
}

int jacobian(realtype, N_Vector, N_Vector, SUNMatrix j, void* data, N_Vector, N_Vector, N_Vector) {
  const SparseColumns& matrix = *static_cast<Callback*>(data)->matrix;
  std::copy_n(matrix.outerIndexPtr(), matrix.cols() + 1, SUNSparseMatrix_IndexPointers(j));
  std::copy_n(matrix.innerIndexPtr(), matrix.nonZeros(), SUNSparseMatrix_IndexValues(j));
  std::copy_n(matrix.valuePtr(), matrix.nonZeros(), SUNSparseMatrix_Data(j));
  return 0;
}

void keep_message(int, const char*, const char* function, char* text, void* data) {
  static_cast<Callback*>(data)->message = fmt::format("{}: {}", function, text);
}

template <class Handle>
Handle created(Handle handle, const char* what) {
  if (handle == nullptr)
    throw std::runtime_error(fmt::format("SUNDIALS could not create {}", what));
  return handle;
}

void check(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(fmt::format("{} returned {}", call, flag));
}

}  // namespace

March march_to_stationarity(const SparseColumns& matrix, const Eigen::VectorXd& start,
                            double tolerance, const TimeScales& scales) {
  constexpr long kMaxSteps = 200;
  // Local errors are no aim here: a step may change the density by as much as itself.
  constexpr double kRelativeTolerance = 1;
  const double absolute_tolerance = start.maxCoeff();
  constexpr double kStepGrowth = 100;

  sundials::Context context;
  Callback callback{&matrix, ""};
  const auto n = static_cast<sunindextype>(matrix.cols());
  const Owned<N_Vector> p(created(N_VNew_Serial(n, context), "a vector"));
  view(p.get()) = start;
  const Owned<SUNMatrix> j(
      created(SUNSparseMatrix(n, n, matrix.nonZeros() + n, CSC_MAT, context), "a sparse matrix"));
  const Owned<SUNLinearSolver> klu(
      created(SUNLinSol_KLU(p.get(), j.get(), context), "the KLU solver"));
  const Owned<void*> cvode(created(CVodeCreate(CV_BDF, context), "CVODE"));
  check(CVodeInit(cvode.get(), right_hand_side, 0.0, p.get()), "CVodeInit");
  check(CVodeSetErrHandlerFn(cvode.get(), keep_message, &callback), "CVodeSetErrHandlerFn");
  check(CVodeSetUserData(cvode.get(), &callback), "CVodeSetUserData");
  check(CVodeSStolerances(cvode.get(), kRelativeTolerance, absolute_tolerance),
        "CVodeSStolerances");
  check(CVodeSetMaxOrd(cvode.get(), 1), "CVodeSetMaxOrd");
  check(CVodeSetInitStep(cvode.get(), scales.first_step), "CVodeSetInitStep");
  check(CVodeSetMaxStep(cvode.get(), scales.longest_step), "CVodeSetMaxStep");
  check(CVodeSetEtaMaxFirstStep(cvode.get(), kStepGrowth), "CVodeSetEtaMaxFirstStep");
  check(CVodeSetEtaMaxEarlyStep(cvode.get(), kStepGrowth), "CVodeSetEtaMaxEarlyStep");
  check(CVodeSetEtaMax(cvode.get(), kStepGrowth), "CVodeSetEtaMax");
  check(SUNLinSol_KLUSetOrdering(klu.get(), 0), "SUNLinSol_KLUSetOrdering");  // AMD
  check(CVodeSetLinearSolver(cvode.get(), klu.get(), j.get()), "CVodeSetLinearSolver");
  check(CVodeSetJacFn(cvode.get(), jacobian), "CVodeSetJacFn");

  March march;
  march.residual = stationarity_residual(matrix, start);
  while (march.residual > tolerance && march.steps < kMaxSteps) {
    realtype time = 0;
    const int flag = CVode(cvode.get(), HUGE_VAL, p.get(), &time, CV_ONE_STEP);
    check(CVodeGetNumSteps(cvode.get(), &march.steps), "CVodeGetNumSteps");
    if (flag < 0) {
      march.reason = fmt::format("CVODE stopped at step {} (flag {}): {}", march.steps, flag,
                                 callback.message);
      break;
    }
    march.residual = stationarity_residual(matrix, view(p.get()));
  }
  check(CVodeGetNumLinSolvSetups(cvode.get(), &march.factorisations), "CVodeGetNumLinSolvSetups");
  check(CVodeGetNumRhsEvals(cvode.get(), &march.rhs_evaluations), "CVodeGetNumRhsEvals");
  march.averages = view(p.get());
  return march;
}

}  // namespace fpkcheck::fd_fpk
