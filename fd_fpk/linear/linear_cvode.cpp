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

CvodeCallbackData& callbacks_in(void* data) { return *static_cast<CvodeCallbackData*>(data); }

int write_product(CvodeCallbackData& callbacks, double t, N_Vector v, N_Vector lv) {
  return callbacks.thrown.invoke([&] {
    vector_view(lv) = callbacks.system.times(t, vector_view(v));
    return 0;
  });
}

int right_hand_side(sunrealtype t, N_Vector p, N_Vector p_dot, void* data) {
  return write_product(callbacks_in(data), t, p, p_dot);
}

int times(N_Vector v, N_Vector lv, sunrealtype t, N_Vector, N_Vector, void* data, N_Vector) {
  return write_product(callbacks_in(data), t, v, lv);
}

int factor(sunrealtype, N_Vector, N_Vector, sunbooleantype, sunbooleantype* current,
           sunrealtype gamma, void* data) {
  auto& callbacks = callbacks_in(data);
  *current = SUNTRUE;
  return callbacks.thrown.invoke(
      [&] { return callbacks.system.factor(gamma) ? 0 : CallbackExceptionStore::kUnrecoverable; });
}

int precondition(sunrealtype, N_Vector, N_Vector, N_Vector r, N_Vector z, sunrealtype, sunrealtype,
                 int, void* data) {
  auto& callbacks = callbacks_in(data);
  return callbacks.thrown.invoke([&] {
    vector_view(z) = vector_view(r);
    callbacks.system.solve(vector_view(z));
    return 0;
  });
}

void store_message(const char* function, const char* text, void* data) {
  auto& callbacks = callbacks_in(data);
  callbacks.thrown.invoke([&] {
    callbacks.message = fmt::format("{}: {}", function, text);
    return 0;
  });
}

}  // namespace

LinearOdeSystem linear_ode_system(LinearOdeSystem::Product times, Preconditioner& preconditioner) {
  return {.times = std::move(times),
          .factor = [&preconditioner](double gamma) { return preconditioner.factorise(gamma); },
          .solve = [&preconditioner](
                       Eigen::Ref<Eigen::VectorXd> b) { preconditioner.solve_in_place(b); }};
}

LinearOdeSystem with_deadline_check(const base::Deadline& deadline, LinearOdeSystem system) {
  system.times = [&deadline, times = std::move(system.times)](double t, const Eigen::VectorXd& p) {
    if (deadline.has_passed()) throw DeadlineExceeded();
    return times(t, p);
  };
  return system;
}

struct LinearCvodeIntegrator::Handles {
  QuietContext context;
  CvodeCallbackData callbacks;
  OwnedHandle<N_Vector> averages;
  OwnedHandle<SUNLinearSolver> gmres;
  OwnedHandle<void*> cvode;

  Handles(LinearOdeSystem system, const Eigen::VectorXd& start)
      : callbacks{std::move(system)},
        averages(make_sundials_vector(start, context)),
        gmres(make_owned(SUNLinSol_SPGMR(averages.get(), SUN_PREC_RIGHT, 100, context),
                         "a GMRES solver")),
        cvode(make_owned(CVodeCreate(CV_BDF, context), "CVODE")) {}

  using Count = int(void* cvode, long* count);
  long count(Count get, const char* call) const {
    long number = 0;
    require_success(get(cvode.get(), &number), call);
    return number;
  }
};

LinearCvodeIntegrator::LinearCvodeIntegrator(LinearOdeSystem system, const Eigen::VectorXd& start,
                                             const BdfSettings& control)
    : handles_(std::make_unique<Handles>(std::move(system), start)) {
  void* const cvode = handles_->cvode.get();
  void* const data = &handles_->callbacks;
  require_success(CVodeInit(cvode, right_hand_side, 0.0, handles_->averages.get()), "CVodeInit");
  set_error_handler<store_message>(cvode, handles_->context, data);
  require_success(CVodeSetUserData(cvode, data), "CVodeSetUserData");
  if (const auto& of_cells = control.absolute_tolerances) {
    const OwnedHandle<N_Vector> tolerances =
        make_sundials_vector(*of_cells, handles_->context);  // CVODE copies the tolerances
    require_success(CVodeSVtolerances(cvode, control.relative_tolerance, tolerances.get()),
                    "CVodeSVtolerances");
  } else {
    require_success(
        CVodeSStolerances(cvode, control.relative_tolerance, control.absolute_tolerance),
        "CVodeSStolerances");
  }
  require_success(CVodeSetMaxOrd(cvode, control.max_order), "CVodeSetMaxOrd");
  require_success(CVodeSetLinearSolver(cvode, handles_->gmres.get(), nullptr),
                  "CVodeSetLinearSolver");
  require_success(CVodeSetJacTimes(cvode, nullptr, times), "CVodeSetJacTimes");
  require_success(CVodeSetPreconditioner(cvode, factor, precondition), "CVodeSetPreconditioner");
  require_success(CVodeSetEpsLin(cvode, control.linear_tolerance), "CVodeSetEpsLin");
  if (const auto& step = control.first_step)
    require_success(CVodeSetInitStep(cvode, *step), "CVodeSetInitStep");
  if (const auto& step = control.max_step)
    require_success(CVodeSetMaxStep(cvode, *step), "CVodeSetMaxStep");
  if (const auto& time = control.stop_time)
    require_success(CVodeSetStopTime(cvode, *time), "CVodeSetStopTime");
  if (const auto& steps = control.max_steps) {
    require_success(CVodeSetMaxNumSteps(cvode, *steps), "CVodeSetMaxNumSteps");
  }
  if (const auto& steps = control.steps_per_factorisation) {
    require_success(CVodeSetLSetupFrequency(cvode, *steps), "CVodeSetLSetupFrequency");
  }
}

LinearCvodeIntegrator::~LinearCvodeIntegrator() = default;

LinearCvodeIntegrator::StepResult LinearCvodeIntegrator::run(double time, int task) {
  StepResult reached{.flag = 0, .time = 0};
  reached.flag = CVode(handles_->cvode.get(), time, handles_->averages.get(), &reached.time, task);
  handles_->callbacks.thrown.rethrow();
  return reached;
}

void LinearCvodeIntegrator::set_linear_tolerance(double tolerance) {
  require_success(CVodeSetEpsLin(handles_->cvode.get(), tolerance), "CVodeSetEpsLin");
}

LinearCvodeIntegrator::StepResult LinearCvodeIntegrator::take_step() {
  return run(HUGE_VAL, CV_ONE_STEP);
}
LinearCvodeIntegrator::StepResult LinearCvodeIntegrator::advance(double time) {
  return run(time, CV_NORMAL);
}

Eigen::Map<const Eigen::VectorXd> LinearCvodeIntegrator::averages() const {
  const auto all = vector_view(handles_->averages.get());
  return {all.data(), all.size()};
}

const std::string& LinearCvodeIntegrator::error_message() const {
  return handles_->callbacks.message;
}

long LinearCvodeIntegrator::step_count() const {
  return handles_->count(CVodeGetNumSteps, "CVodeGetNumSteps");
}
long LinearCvodeIntegrator::factorisation_count() const {
  return handles_->count(CVodeGetNumPrecEvals, "CVodeGetNumPrecEvals");
}
long LinearCvodeIntegrator::rhs_evaluation_count() const {
  return handles_->count(CVodeGetNumRhsEvals, "CVodeGetNumRhsEvals");
}
long LinearCvodeIntegrator::krylov_iteration_count() const {
  return handles_->count(CVodeGetNumLinIters, "CVodeGetNumLinIters");
}

}  // namespace fpkcheck::fd_fpk
