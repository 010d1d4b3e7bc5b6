#include "fd_fpk/linear/gmres.hpp"

#include <algorithm>

#include "numerics/ode/sundials_handles.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using namespace numerics::sundials_owned;

struct GmresCallbackData {
  const LinearMap& a;
  const ApproximateSolve& approximate_solve;
  const base::Deadline& deadline;
  bool deadline_exceeded = false;
  CallbackExceptionStore thrown = {};
};

int times(void* data, N_Vector v, N_Vector z) {
  auto& callbacks = *static_cast<GmresCallbackData*>(data);
  return callbacks.thrown.invoke([&] {
    callbacks.deadline_exceeded = callbacks.deadline.has_passed();
    if (callbacks.deadline_exceeded) return CallbackExceptionStore::kUnrecoverable;
    vector_view(z) = callbacks.a(vector_view(v));
    return 0;
  });
}

int precondition(void* data, N_Vector r, N_Vector z, sunrealtype, int) {
  auto& callbacks = *static_cast<GmresCallbackData*>(data);
  return callbacks.thrown.invoke([&] {
    vector_view(z) = vector_view(r);
    callbacks.approximate_solve(vector_view(z));
    return 0;
  });
}

}  // namespace

GmresResult gmres(const LinearMap& a, const ApproximateSolve& approximate_solve,
                  const Eigen::VectorXd& b, const Eigen::VectorXd& weights, double tolerance,
                  const base::Deadline& deadline) {
  constexpr int kBasis = 100;
  constexpr int kRestarts = 4;
  QuietContext context;
  GmresCallbackData callbacks{a, approximate_solve, deadline};
  const auto x = make_sundials_vector(Eigen::VectorXd::Zero(b.size()), context);
  const auto right = make_sundials_vector(b, context);
  const auto scale = make_sundials_vector(weights, context);
  const auto solver =
      make_owned(SUNLinSol_SPGMR(x.get(), SUN_PREC_RIGHT, kBasis, context), "a GMRES solver");
  require_success(SUNLinSol_SPGMRSetMaxRestarts(solver.get(), kRestarts),
                  "SUNLinSol_SPGMRSetMaxRestarts");
  require_success(SUNLinSolSetATimes(solver.get(), &callbacks, times), "SUNLinSolSetATimes");
  require_success(SUNLinSolSetPreconditioner(solver.get(), &callbacks, nullptr, precondition),
                  "SUNLinSolSetPreconditioner");
  require_success(SUNLinSolSetScalingVectors(solver.get(), scale.get(), scale.get()),
                  "SUNLinSolSetScalingVectors");
  require_success(SUNLinSolInitialize(solver.get()), "SUNLinSolInitialize");
  require_success(SUNLinSolSetup(solver.get(), nullptr), "SUNLinSolSetup");
  // A Krylov basis loses orthogonality before the residual has fallen by much more than the factor
  // kReduction. On fine grids only a restart reduces the residual below this factor.
  constexpr double kReduction = 1e-7;
  const double norm = weights.cwiseProduct(b).norm();
  GmresResult result{std::nullopt};
  int flag = kSuccess;
  for (double reached = 1; reached > tolerance;) {
    require_success(SUNLinSolSetZeroGuess(solver.get(), reached == 1 ? SUNTRUE : SUNFALSE),
                    "SUNLinSolSetZeroGuess");
    reached = std::max(tolerance, kReduction * reached);
    flag = SUNLinSolSolve(solver.get(), nullptr, x.get(), right.get(), reached * norm);
    callbacks.thrown.rethrow();
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
