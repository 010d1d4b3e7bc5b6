#include "fd_fpk/linear/gmres.hpp"

#include <algorithm>

#include "numerics/ode/sundials_handles.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using namespace numerics::sundials_owned;

struct GmresCallbackData {
  const LinearMap& linear_map;
  const ApproximateLinearSolver& approximate_solve;
  const base::Deadline& deadline;
  bool deadline_exceeded = false;
  CallbackExceptionStore thrown = {};
};

int gmres_product_callback(void* data, N_Vector v, N_Vector z) {
  auto& callbacks = *static_cast<GmresCallbackData*>(data);
  return callbacks.thrown.call_and_store_exception([&] {
    callbacks.deadline_exceeded = callbacks.deadline.has_deadline_passed();
    if (callbacks.deadline_exceeded) return CallbackExceptionStore::kUnrecoverable;
    vector_view(z) = callbacks.linear_map(vector_view(v));
    return 0;
  });
}

int gmres_precondition_callback(void* data, N_Vector r, N_Vector z, sunrealtype, int) {
  auto& callbacks = *static_cast<GmresCallbackData*>(data);
  return callbacks.thrown.call_and_store_exception([&] {
    vector_view(z) = vector_view(r);
    callbacks.approximate_solve(vector_view(z));
    return 0;
  });
}

}  // namespace

GmresResult solve_by_gmres(const LinearMap& linear_map,
                           const ApproximateLinearSolver& approximate_solve,
                           const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& weights,
                           double tolerance, const base::Deadline& deadline) {
  constexpr int kBasis = 100;
  constexpr int kRestarts = 4;
  SilentSundialsContext context;
  GmresCallbackData callbacks{linear_map, approximate_solve, deadline};
  const auto x = make_sundials_vector(Eigen::VectorXd::Zero(right_hand_side.size()), context);
  const auto right = make_sundials_vector(right_hand_side, context);
  const auto scale = make_sundials_vector(weights, context);
  const auto solver = make_owned_handle(SUNLinSol_SPGMR(x.get(), SUN_PREC_RIGHT, kBasis, context),
                                        "a GMRES solver");
  require_success(SUNLinSol_SPGMRSetMaxRestarts(solver.get(), kRestarts),
                  "SUNLinSol_SPGMRSetMaxRestarts");
  require_success(SUNLinSolSetATimes(solver.get(), &callbacks, gmres_product_callback),
                  "SUNLinSolSetATimes");
  require_success(
      SUNLinSolSetPreconditioner(solver.get(), &callbacks, nullptr, gmres_precondition_callback),
      "SUNLinSolSetPreconditioner");
  require_success(SUNLinSolSetScalingVectors(solver.get(), scale.get(), scale.get()),
                  "SUNLinSolSetScalingVectors");
  require_success(SUNLinSolInitialize(solver.get()), "SUNLinSolInitialize");
  require_success(SUNLinSolSetup(solver.get(), nullptr), "SUNLinSolSetup");
  // The Krylov basis of GMRES loses orthogonality before the residual has fallen by much more than
  // a factor of 1e7. On fine grids only a restart of GMRES reduces the residual further.
  constexpr double kReduction = 1e-7;
  const double norm = weights.cwiseProduct(right_hand_side).norm();
  GmresResult result{std::nullopt};
  int flag = kSuccess;
  for (double reached = 1; reached > tolerance;) {
    require_success(SUNLinSolSetZeroGuess(solver.get(), reached == 1 ? SUNTRUE : SUNFALSE),
                    "SUNLinSolSetZeroGuess");
    reached = std::max(tolerance, kReduction * reached);
    flag = SUNLinSolSolve(solver.get(), nullptr, x.get(), right.get(), reached * norm);
    callbacks.thrown.rethrow_stored_exception();
    result.iterations += SUNLinSolNumIters(solver.get());
    if (flag < 0) break;
  }
  if (callbacks.deadline_exceeded) {
    result.failure = fmt::format(
        "max_seconds expired after {} iterations of GMRES; increase max-seconds or use fewer cells",
        result.iterations);
    return result;
  }
  const bool reduced = flag == kSuccess || flag == SUNLS_RES_REDUCED;
  if (reduced && vector_view(x.get()).allFinite()) {
    result.solution = vector_view(x.get());
  } else {
    result.failure =
        fmt::format("GMRES did not converge in {} iterations (flag {}); use another grid",
                    result.iterations, flag);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
