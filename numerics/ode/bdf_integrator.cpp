#include "numerics/ode/bdf_integrator.hpp"

#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <utility>

#include "numerics/ode/sundials_handles.hpp"

namespace fpkcheck::numerics {

using namespace sundials_owned;

struct BdfCallbackData {
  OdeSystem system;
  std::string message = {};
  CallbackExceptionStore thrown = {};
};

namespace {

constexpr int kRecoverable = 1;  // positive flag of a callback: CVODE reduces the step

BdfCallbackData& bdf_callbacks(void* data) { return *static_cast<BdfCallbackData*>(data); }

int evaluate_rate(sunrealtype t, N_Vector x, N_Vector rate, void* data) {
  BdfCallbackData& callbacks = bdf_callbacks(data);
  return callbacks.thrown.invoke([&] {
    return callbacks.system.rate(t, vector_view(x), vector_view(rate)) ? kSuccess : kRecoverable;
  });
}

int evaluate_jacobian(sunrealtype t, N_Vector x, N_Vector, SUNMatrix jacobian, void* data, N_Vector,
                      N_Vector, N_Vector) {
  BdfCallbackData& callbacks = bdf_callbacks(data);
  return callbacks.thrown.invoke([&] {
    Eigen::Map<Eigen::MatrixXd> matrix(SUNDenseMatrix_Data(jacobian), SUNDenseMatrix_Rows(jacobian),
                                       SUNDenseMatrix_Columns(jacobian));
    return callbacks.system.jacobian(t, vector_view(x), matrix) ? kSuccess : kRecoverable;
  });
}

void keep_message(const char* function, const char* text, void* data) {
  BdfCallbackData& callbacks = bdf_callbacks(data);
  callbacks.thrown.invoke([&] {
    callbacks.message = fmt::format("{}: {}", function, text);
    return kSuccess;
  });
}

}  // namespace

struct BdfIntegrator::Handles {
  QuietContext context;
  BdfCallbackData callbacks;
  OwnedHandle<N_Vector> state;
  OwnedHandle<SUNMatrix> matrix;
  OwnedHandle<SUNLinearSolver> lu;
  OwnedHandle<void*> cvode;

  Handles(OdeSystem system, const Eigen::VectorXd& start)
      : callbacks{std::move(system)},
        state(make_sundials_vector(start, context)),
        matrix(make_owned(SUNDenseMatrix(start.size(), start.size(), context), "a matrix")),
        lu(make_owned(SUNLinSol_Dense(state.get(), matrix.get(), context), "an LU solver")),
        cvode(make_owned(CVodeCreate(CV_BDF, context), "CVODE")) {}
};

BdfIntegrator::BdfIntegrator(OdeSystem system, const Eigen::VectorXd& start,
                             const BdfSettings& settings)
    : handles_(std::make_unique<Handles>(std::move(system), start)) {
  constexpr long kMostSteps = 100000;  // between two calls of advance()
  void* const cvode = handles_->cvode.get();
  void* const data = &handles_->callbacks;
  require_success(CVodeInit(cvode, evaluate_rate, 0.0, handles_->state.get()), "CVodeInit");
  set_error_handler<keep_message>(cvode, handles_->context, data);
  require_success(CVodeSetUserData(cvode, data), "CVodeSetUserData");
  require_success(CVodeSStolerances(cvode, settings.relative, settings.absolute),
                  "CVodeSStolerances");
  require_success(CVodeSetLinearSolver(cvode, handles_->lu.get(), handles_->matrix.get()),
                  "CVodeSetLinearSolver");
  require_success(CVodeSetJacFn(cvode, evaluate_jacobian), "CVodeSetJacFn");
  require_success(CVodeSetMaxNumSteps(cvode, kMostSteps), "CVodeSetMaxNumSteps");
  if (const auto& step = settings.max_step) {
    require_success(CVodeSetMaxStep(cvode, *step), "CVodeSetMaxStep");
  }
  if (const auto& time = settings.stop_time) {
    require_success(CVodeSetStopTime(cvode, *time), "CVodeSetStopTime");
  }
}

BdfIntegrator::~BdfIntegrator() = default;

bool BdfIntegrator::advance(double time) {
  void* const cvode = handles_->cvode.get();
  sunrealtype returned = 0, current = 0;
  const int flag = CVode(cvode, time, handles_->state.get(), &returned, CV_NORMAL);
  handles_->callbacks.thrown.rethrow();
  // CVODE reports success before `time` if the step size underflows to 0.
  require_success(CVodeGetCurrentTime(cvode, &current), "CVodeGetCurrentTime");
  return flag >= 0 && current >= time;
}

Eigen::VectorXd BdfIntegrator::state() const { return vector_view(handles_->state.get()); }

const std::string& BdfIntegrator::error_message() const { return handles_->callbacks.message; }

long BdfIntegrator::step_count() const {
  long number = 0;
  require_success(CVodeGetNumSteps(handles_->cvode.get(), &number), "CVodeGetNumSteps");
  return number;
}

}  // namespace fpkcheck::numerics
