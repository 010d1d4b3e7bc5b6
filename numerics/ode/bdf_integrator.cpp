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

BdfCallbackData& bdf_callback_data(void* data) { return *static_cast<BdfCallbackData*>(data); }

int ode_rate_callback(sunrealtype t, N_Vector x, N_Vector rate, void* data) {
  BdfCallbackData& callbacks = bdf_callback_data(data);
  return callbacks.thrown.call_and_store_exception([&] {
    return callbacks.system.rate(t, vector_view(x), vector_view(rate)) ? kSuccess : kRecoverable;
  });
}

int ode_jacobian_callback(sunrealtype t, N_Vector x, N_Vector, SUNMatrix jacobian, void* data,
                          N_Vector, N_Vector, N_Vector) {
  BdfCallbackData& callbacks = bdf_callback_data(data);
  return callbacks.thrown.call_and_store_exception([&] {
    Eigen::Map<Eigen::MatrixXd> matrix(SUNDenseMatrix_Data(jacobian), SUNDenseMatrix_Rows(jacobian),
                                       SUNDenseMatrix_Columns(jacobian));
    return callbacks.system.jacobian(t, vector_view(x), matrix) ? kSuccess : kRecoverable;
  });
}

void store_bdf_error_message(const char* function, const char* text, void* data) {
  BdfCallbackData& callbacks = bdf_callback_data(data);
  callbacks.thrown.call_and_store_exception([&] {
    callbacks.message = fmt::format("{}: {}", function, text);
    return kSuccess;
  });
}

}  // namespace

struct BdfIntegrator::Handles {
  SilentSundialsContext context;
  BdfCallbackData callbacks;
  OwnedHandle<N_Vector> state;
  OwnedHandle<SUNMatrix> matrix;
  OwnedHandle<SUNLinearSolver> lu;
  OwnedHandle<void*> cvode;

  Handles(OdeSystem system, const Eigen::VectorXd& initial_state)
      : callbacks{std::move(system)},
        state(make_sundials_vector(initial_state, context)),
        matrix(make_owned_handle(
            SUNDenseMatrix(initial_state.size(), initial_state.size(), context), "a matrix")),
        lu(make_owned_handle(SUNLinSol_Dense(state.get(), matrix.get(), context), "an LU solver")),
        cvode(make_owned_handle(CVodeCreate(CV_BDF, context), "CVODE")) {}
};

BdfIntegrator::BdfIntegrator(OdeSystem system, const Eigen::VectorXd& initial_state,
                             const BdfSettings& settings)
    : handles_(std::make_unique<Handles>(std::move(system), initial_state)) {
  constexpr long kMostSteps = 100000;  // largest number in a call of advance_to_time()
  void* const cvode = handles_->cvode.get();
  void* const data = &handles_->callbacks;
  require_success(CVodeInit(cvode, ode_rate_callback, 0.0, handles_->state.get()), "CVodeInit");
  set_error_handler<store_bdf_error_message>(cvode, handles_->context, data);
  require_success(CVodeSetUserData(cvode, data), "CVodeSetUserData");
  require_success(
      CVodeSStolerances(cvode, settings.relative_tolerance, settings.absolute_tolerance),
      "CVodeSStolerances");
  require_success(CVodeSetLinearSolver(cvode, handles_->lu.get(), handles_->matrix.get()),
                  "CVodeSetLinearSolver");
  require_success(CVodeSetJacFn(cvode, ode_jacobian_callback), "CVodeSetJacFn");
  require_success(CVodeSetMaxNumSteps(cvode, kMostSteps), "CVodeSetMaxNumSteps");
  if (const auto& step = settings.max_step) {
    require_success(CVodeSetMaxStep(cvode, *step), "CVodeSetMaxStep");
  }
  if (const auto& time = settings.stop_time) {
    require_success(CVodeSetStopTime(cvode, *time), "CVodeSetStopTime");
  }
}

BdfIntegrator::~BdfIntegrator() = default;

bool BdfIntegrator::advance_to_time(double time) {
  void* const cvode = handles_->cvode.get();
  sunrealtype returned = 0, current = 0;
  const int flag = CVode(cvode, time, handles_->state.get(), &returned, CV_NORMAL);
  handles_->callbacks.thrown.rethrow_stored_exception();
  // CVODE reports success before the requested time if the step size underflows to 0.
  require_success(CVodeGetCurrentTime(cvode, &current), "CVodeGetCurrentTime");
  return flag >= 0 && current >= time;
}

Eigen::VectorXd BdfIntegrator::current_state() const { return vector_view(handles_->state.get()); }

const std::string& BdfIntegrator::error_message() const { return handles_->callbacks.message; }

long BdfIntegrator::step_count() const {
  long number = 0;
  require_success(CVodeGetNumSteps(handles_->cvode.get(), &number), "CVodeGetNumSteps");
  return number;
}

}  // namespace fpkcheck::numerics
