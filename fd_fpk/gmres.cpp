#include "fd_fpk/gmres.hpp"

#include <algorithm>

#include "fd_fpk/sundials.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using namespace sundials_owned;

struct Callbacks {
  const LinearMap& a;
  const ApproximateSolve& nearby;
};

int times(void* data, N_Vector v, N_Vector z) {
  view(z) = static_cast<Callbacks*>(data)->a(view(v));
  return 0;
}

int precondition(void* data, N_Vector r, N_Vector z, realtype, int) {
  view(z) = view(r);
  static_cast<Callbacks*>(data)->nearby(view(z));
  return 0;
}

}  // namespace

GmresResult gmres(const LinearMap& a, const ApproximateSolve& nearby, const Eigen::VectorXd& b,
                  const Eigen::VectorXd& weights, double tolerance) {
  constexpr int kBasis = 100;
  constexpr int kRestarts = 4;
  sundials::Context context;
  Callbacks callbacks{a, nearby};
  const auto x = vector_of(Eigen::VectorXd::Zero(b.size()), context);
  const auto right = vector_of(b, context);
  const auto scale = vector_of(weights, context);
  const auto solver =
      owned(SUNLinSol_SPGMR(x.get(), SUN_PREC_RIGHT, kBasis, context), "a GMRES solver");
  check(SUNLinSol_SPGMRSetMaxRestarts(solver.get(), kRestarts), "SUNLinSol_SPGMRSetMaxRestarts");
  check(SUNLinSolSetATimes(solver.get(), &callbacks, times), "SUNLinSolSetATimes");
  check(SUNLinSolSetPreconditioner(solver.get(), &callbacks, nullptr, precondition),
        "SUNLinSolSetPreconditioner");
  check(SUNLinSolSetScalingVectors(solver.get(), scale.get(), scale.get()),
        "SUNLinSolSetScalingVectors");
  check(SUNLinSolInitialize(solver.get()), "SUNLinSolInitialize");
  check(SUNLinSolSetup(solver.get(), nullptr), "SUNLinSolSetup");
  // One basis loses its orthogonality before the residual has fallen by much more than kReduction,
  // and then runs to its end: on fine grids without any gain.
  constexpr double kReduction = 1e-7;
  const double norm = weights.cwiseProduct(b).norm();
  GmresResult result{std::nullopt};
  int flag = SUNLS_SUCCESS;
  for (double reached = 1; reached > tolerance;) {
    check(SUNLinSolSetZeroGuess(solver.get(), reached == 1 ? SUNTRUE : SUNFALSE),
          "SUNLinSolSetZeroGuess");
    reached = std::max(tolerance, kReduction * reached);
    flag = SUNLinSolSolve(solver.get(), nullptr, x.get(), right.get(), reached * norm);
    result.iterations += SUNLinSolNumIters(solver.get());
    if (flag < 0) break;
  }
  const bool reduced = flag == SUNLS_SUCCESS || flag == SUNLS_RES_REDUCED;
  if (reduced && view(x.get()).allFinite()) {
    result.solution = view(x.get());
  } else {
    result.failure =
        fmt::format("GMRES did not converge in {} iterations (flag {})", result.iterations, flag);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
