#include "fd_fpk/linear/preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/process/stopwatch.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Order of accuracy of the preconditioner matrix M if the Fokker-Planck operator L has an odd
// order. With coefficients evaluated at the cell centres, a scheme of order 3 couples each cell
// only to cells of the same row and of the same column of the grid. Among the orders for which
// GMRES converges well, order 3 has the fewest nonzero matrix entries.
constexpr int kOrder = 3;

// Returns a drift a and a diffusion D that approximate the exchange matrix of velocity jumps. The
// exchange matrix has the symbol -i a q - D q^2 at small wavenumbers q, and
// -preconditioner_exchange_decay_rate at large wavenumbers. The diffusion term would damp the
// shortest waves on cells of the width h, with the wavenumber pi/h, far too strongly. The upper
// limit of the diffusion coefficient makes the shortest waves decay at about
// preconditioner_exchange_decay_rate. The drift by impulses of nonzero mean is significant, since
// it keeps the oscillator off the wall. The preconditioner therefore reduces the drift only if the
// drift rate of the shortest waves is many times preconditioner_exchange_decay_rate.
DiscretisedExcitation drift_diffusion_approximation(const DiscretisedExcitation& excitation,
                                                    const GridAxis& x2) {
  constexpr double kOvershoot = 1.5;
  const double step = x2.smallest_cell_width();
  // Empirical limits: on graded axes with narrow cells GMRES does not converge with larger drift or
  // diffusion coefficients.
  const double overshoot_of_drift = x2.cell_widths().maxCoeff() > 1.5 * step ? 3 : 10;
  const double shortest = std::numbers::pi / step;
  const double fastest =
      overshoot_of_drift * excitation.preconditioner_exchange_decay_rate / shortest;
  const double limit =
      kOvershoot * excitation.preconditioner_exchange_decay_rate / (shortest * shortest);
  DiscretisedExcitation local{
      .drift = excitation.drift +
               std::clamp(excitation.preconditioner_exchange_drift, -fastest, fastest),
      .diffusion = excitation.diffusion,
      .exchange = {},
      .state_dependent_diffusion = excitation.state_dependent_diffusion};
  if (!excitation.parametric) {
    local.diffusion += std::min(excitation.preconditioner_exchange_diffusion, limit);
    return local;
  }
  // The mean impulse amplitude E[Y] is 0, so that the drift of parametric impulses is 0.
  StateDependentDiffusion& variable = local.state_dependent_diffusion
                                          ? *local.state_dependent_diffusion
                                          : local.state_dependent_diffusion.emplace();
  variable.coefficient =
      [=, of_noise = variable.coefficient, factor = excitation.parametric->factor,
       of_impulses = excitation.preconditioner_exchange_diffusion](double y, double v) {
        const double b = factor(y, 0);
        return (of_noise ? of_noise(y, v) : 0) + std::min(of_impulses * b * b, limit);
      };
  return local;
}

}  // namespace

Preconditioner::Preconditioner(const problem::Problem& problem,
                               const DiscretisedExcitation& excitation,
                               problem::ImpactCondition impact, const PhasePlaneGrid& grid,
                               int order)
    : Preconditioner(problem.system, problem::motion_scales(problem).slowest_decay_rate, excitation,
                     impact, grid, order) {}

Preconditioner::Preconditioner(const problem::System& system, double mass_loss_rate,
                               const DiscretisedExcitation& excitation,
                               problem::ImpactCondition impact, const PhasePlaneGrid& grid,
                               int order)
    : mass_loss_rate_(mass_loss_rate) {
  const bool centred = order % 2 == 0;
  approximation_ = scale_and_shift_matrix(
      1,
      fokker_planck_operator(
          system, drift_diffusion_approximation(excitation, grid.x2), impact, grid,
          centred ? order : kOrder,
          centred ? CellAverageProductRule::full : CellAverageProductRule::lumped)
          .local,
      -mass_loss_rate);
}

bool Preconditioner::factor_with_klu(const SparseColumnMatrix& matrix) {
  const base::Stopwatch stopwatch;
  const bool succeeded = klu_.factorise(matrix);
  are_stationary_ = succeeded && &matrix == &approximation_;
  matrix_scale_ = 1;
  ++factorisations_;
  factor_seconds_ += stopwatch.seconds();
  return succeeded;
}

bool Preconditioner::factorise_newton_matrix(double gamma) {
  // ratio of the step coefficient gamma to the decay time above which the factors of the
  // preconditioner matrix M are reused
  constexpr double kLong = 3;
  if (are_stationary_ && gamma * mass_loss_rate_ >= kLong) {
    matrix_scale_ = -gamma;
    return true;
  }
  factored_ = scale_and_shift_matrix(-gamma, approximation_, 1);
  return factor_with_klu(factored_);
}

bool Preconditioner::factorise_stationary() {
  if (!are_stationary_) return factor_with_klu(approximation_);
  matrix_scale_ = 1;
  return true;
}

void Preconditioner::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  klu_.solve_in_place(b);
  b /= matrix_scale_;
}

void Preconditioner::solve_transposed_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  klu_.solve_transposed_in_place(b);
  b /= matrix_scale_;
}

}  // namespace fpkcheck::fd_fpk
