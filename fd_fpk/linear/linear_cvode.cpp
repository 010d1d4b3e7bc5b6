#include "fd_fpk/linear/linear_cvode.hpp"

#include <cmath>

#include "fd_fpk/linear/gmres.hpp"
#include "numerics/ode/sundials_handles.hpp"

namespace fpkcheck::fd_fpk {

struct CvodeCallbackData {
  LinearOdeSystem system;
  std::string message = {};
  numerics::sundials_owned::CallbackExceptionStore thrown = {};
};

namespace {

using namespace numerics::sundials_owned;

CvodeCallbackData& cvode_callback_data(void* data) {
  return *static_cast<CvodeCallbackData*>(data);
}

int store_product_or_exception(CvodeCallbackData& callbacks, double t, N_Vector v, N_Vector lv) {
  return callbacks.thrown.call_and_store_exception([&] {
    vector_view(lv) = callbacks.system.apply_operator(t, vector_view(v));
    return 0;
  });
}

int right_hand_side_callback(sunrealtype t, N_Vector p, N_Vector p_dot, void* data) {
  return store_product_or_exception(cvode_callback_data(data), t, p, p_dot);
}

int jacobian_product_callback(N_Vector v, N_Vector lv, sunrealtype t, N_Vector, N_Vector,
                              void* data, N_Vector) {
  return store_product_or_exception(cvode_callback_data(data), t, v, lv);
}

int preconditioner_setup_callback(sunrealtype, N_Vector, N_Vector, sunbooleantype,
                                  sunbooleantype* current, sunrealtype gamma, void* data) {
  auto& callbacks = cvode_callback_data(data);
  *current = SUNTRUE;
  return callbacks.thrown.call_and_store_exception([&] {
    return callbacks.system.factor_shifted_matrix(gamma) ? 0
                                                         : CallbackExceptionStore::kUnrecoverable;
  });
}

int preconditioner_solve_callback(sunrealtype, N_Vector, N_Vector, N_Vector r, N_Vector z,
                                  sunrealtype, sunrealtype, int, void* data) {
  auto& callbacks = cvode_callback_data(data);
  return callbacks.thrown.call_and_store_exception([&] {
    vector_view(z) = vector_view(r);
    callbacks.system.approximate_solve(vector_view(z));
    return 0;
  });
}

void store_cvode_error_message(const char* function, const char* text, void* data) {
  auto& callbacks = cvode_callback_data(data);
  callbacks.thrown.call_and_store_exception([&] {
    callbacks.message = fmt::format("{}: {}", function, text);
    return 0;
  });
}

}  // namespace

LinearOdeSystem make_linear_ode_system(LinearOdeSystem::Product apply_operator,
                                       Preconditioner& preconditioner) {
  return {
      .apply_operator = std::move(apply_operator),
      .factor_shifted_matrix =
          [&preconditioner](double gamma) { return preconditioner.factorise_newton_matrix(gamma); },
      .approximate_solve =
          [&preconditioner](Eigen::Ref<Eigen::VectorXd> b) { preconditioner.solve_in_place(b); }};
}

LinearOdeSystem with_deadline_check(const base::Deadline& deadline, LinearOdeSystem system) {
  system.apply_operator = [&deadline, apply_operator = std::move(system.apply_operator)](
                              double t, const Eigen::VectorXd& p) {
    if (deadline.has_deadline_passed()) throw DeadlineExceeded();
    return apply_operator(t, p);
  };
  return system;
}

struct LinearCvodeIntegrator::Handles {
  SilentSundialsContext context;
  CvodeCallbackData callbacks;
  OwnedHandle<N_Vector> averages;
  OwnedHandle<SUNLinearSolver> gmres;
  OwnedHandle<void*> cvode;

  Handles(LinearOdeSystem system, const Eigen::VectorXd& initial_averages)
      : callbacks{std::move(system)},
        averages(make_sundials_vector(initial_averages, context)),
        gmres(make_owned_handle(SUNLinSol_SPGMR(averages.get(), SUN_PREC_RIGHT, 100, context),
                                "a GMRES solver")),
        cvode(make_owned_handle(CVodeCreate(CV_BDF, context), "CVODE")) {}

  using CounterQuery = int(void* cvode, long* count);
  long query_counter(CounterQuery query, const char* function_name) const {
    long number = 0;
    require_success(query(cvode.get(), &number), function_name);
    return number;
  }
};

LinearCvodeIntegrator::LinearCvodeIntegrator(LinearOdeSystem system,
                                             const Eigen::VectorXd& initial_averages,
                                             const BdfSettings& settings)
    : handles_(std::make_unique<Handles>(std::move(system), initial_averages)) {
  void* const cvode = handles_->cvode.get();
  void* const data = &handles_->callbacks;
  require_success(CVodeInit(cvode, right_hand_side_callback, 0.0, handles_->averages.get()),
                  "CVodeInit");
  set_error_handler<store_cvode_error_message>(cvode, handles_->context, data);
  require_success(CVodeSetUserData(cvode, data), "CVodeSetUserData");
  if (const auto& of_cells = settings.absolute_tolerances) {
    const OwnedHandle<N_Vector> tolerances =
        make_sundials_vector(*of_cells, handles_->context);  // CVODE copies the tolerances
    require_success(CVodeSVtolerances(cvode, settings.relative_tolerance, tolerances.get()),
                    "CVodeSVtolerances");
  } else {
    require_success(
        CVodeSStolerances(cvode, settings.relative_tolerance, settings.absolute_tolerance),
        "CVodeSStolerances");
  }
  require_success(CVodeSetMaxOrd(cvode, settings.max_order), "CVodeSetMaxOrd");
  require_success(CVodeSetLinearSolver(cvode, handles_->gmres.get(), nullptr),
                  "CVodeSetLinearSolver");
  require_success(CVodeSetJacTimes(cvode, nullptr, jacobian_product_callback), "CVodeSetJacTimes");
  require_success(
      CVodeSetPreconditioner(cvode, preconditioner_setup_callback, preconditioner_solve_callback),
      "CVodeSetPreconditioner");
  require_success(CVodeSetEpsLin(cvode, settings.linear_tolerance), "CVodeSetEpsLin");
  if (const auto& step = settings.first_step)
    require_success(CVodeSetInitStep(cvode, *step), "CVodeSetInitStep");
  if (const auto& step = settings.max_step)
    require_success(CVodeSetMaxStep(cvode, *step), "CVodeSetMaxStep");
  if (const auto& time = settings.stop_time)
    require_success(CVodeSetStopTime(cvode, *time), "CVodeSetStopTime");
  if (const auto& steps = settings.max_steps) {
    require_success(CVodeSetMaxNumSteps(cvode, *steps), "CVodeSetMaxNumSteps");
  }
  if (const auto& steps = settings.steps_per_factorisation) {
    require_success(CVodeSetLSetupFrequency(cvode, *steps), "CVodeSetLSetupFrequency");
  }
}

LinearCvodeIntegrator::~LinearCvodeIntegrator() = default;

LinearCvodeIntegrator::StepResult LinearCvodeIntegrator::call_cvode(double time, int cvode_task) {
  StepResult reached{.flag = 0, .time = 0};
  reached.flag =
      CVode(handles_->cvode.get(), time, handles_->averages.get(), &reached.time, cvode_task);
  handles_->callbacks.thrown.rethrow_stored_exception();
  return reached;
}

void LinearCvodeIntegrator::set_linear_tolerance(double tolerance) {
  require_success(CVodeSetEpsLin(handles_->cvode.get(), tolerance), "CVodeSetEpsLin");
}

LinearCvodeIntegrator::StepResult LinearCvodeIntegrator::take_step() {
  return call_cvode(HUGE_VAL, CV_ONE_STEP);
}
LinearCvodeIntegrator::StepResult LinearCvodeIntegrator::advance_to_time(double time) {
  return call_cvode(time, CV_NORMAL);
}

Eigen::Map<const Eigen::VectorXd> LinearCvodeIntegrator::cell_averages() const {
  const auto all = vector_view(handles_->averages.get());
  return {all.data(), all.size()};
}

const std::string& LinearCvodeIntegrator::error_message() const {
  return handles_->callbacks.message;
}

long LinearCvodeIntegrator::step_count() const {
  return handles_->query_counter(CVodeGetNumSteps, "CVodeGetNumSteps");
}
long LinearCvodeIntegrator::factorisation_count() const {
  return handles_->query_counter(CVodeGetNumPrecEvals, "CVodeGetNumPrecEvals");
}
long LinearCvodeIntegrator::rhs_evaluation_count() const {
  return handles_->query_counter(CVodeGetNumRhsEvals, "CVodeGetNumRhsEvals");
}
long LinearCvodeIntegrator::krylov_iteration_count() const {
  return handles_->query_counter(CVodeGetNumLinIters, "CVodeGetNumLinIters");
}

}  // namespace fpkcheck::fd_fpk
