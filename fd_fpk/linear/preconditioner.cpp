#include "fd_fpk/linear/preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fd_fpk/stopwatch.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Order 3: with lumped weights each row couples one row and one column of cells only. It has the
// fewest entries of all orders for which GMRES converges well.
constexpr int kOrder = 3;

// The exchange acts as -i a q - D q^2 on long waves and saturates at its rate on short waves. A
// diffusion of full strength would be far too strong for the shortest waves of a fine grid, q =
// pi/h. It is limited to the size of the saturated rate there. The drift, by which a mean of the
// impulses holds the oscillator off the wall, is limited only where it is many times that rate.
Excitation local_approximation(const Excitation& excitation, const Axis& x2) {
  constexpr double kOvershoot = 1.5;
  const double step = x2.smallest_width();
  // Empirical: on graded axes with narrow cells GMRES does not converge for larger values.
  const double overshoot_of_drift = x2.widths().maxCoeff() > 1.5 * step ? 3 : 10;
  const double shortest = std::numbers::pi / step;
  const double fastest = overshoot_of_drift * excitation.exchange_rate / shortest;
  return {.drift = excitation.drift + std::clamp(excitation.exchange_drift, -fastest, fastest),
          .diffusion = excitation.diffusion +
                       std::min(excitation.exchange_diffusion,
                                kOvershoot * excitation.exchange_rate / (shortest * shortest)),
          .exchange = {}};
}

}  // namespace

Preconditioner::Preconditioner(const problem::Problem& problem, const Excitation& excitation,
                               problem::Impact impact, const Grid& grid, int order)
    : Preconditioner(problem.system, problem::scales(problem).slowest_decay_rate, excitation,
                     impact, grid, order) {}

Preconditioner::Preconditioner(const problem::System& system, double loss,
                               const Excitation& excitation, problem::Impact impact,
                               const Grid& grid, int order)
    : loss_(loss) {
  const bool centred = order % 2 == 0;
  approximation_ =
      scale_and_shift(1,
                      fokker_planck_operator(system, local_approximation(excitation, grid.x2),
                                             impact, grid, centred ? order : kOrder,
                                             centred ? Weighting::full : Weighting::lumped)
                          .local,
                      -loss);
}

bool Preconditioner::factor_with_klu(const SparseColumns& matrix) {
  const Stopwatch stopwatch;
  const bool succeeded = klu_.factor(matrix);
  are_stationary_ = &matrix == &approximation_;
  matrix_scale_ = 1;
  ++factorisations_;
  factor_seconds_ += stopwatch.seconds();
  return succeeded;
}

bool Preconditioner::factor(double gamma) {
  constexpr double kLong = 3;  // decay times
  if (are_stationary_ && gamma * loss_ >= kLong) {
    matrix_scale_ = -gamma;
    return true;
  }
  factored_ = scale_and_shift(-gamma, approximation_, 1);
  return factor_with_klu(factored_);
}

bool Preconditioner::factor_stationary() { return factor_with_klu(approximation_); }

void Preconditioner::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  klu_.solve_in_place(b);
  b /= matrix_scale_;
}

}  // namespace fpkcheck::fd_fpk
