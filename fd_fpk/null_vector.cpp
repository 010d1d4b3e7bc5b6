#include "fd_fpk/null_vector.hpp"

#include "fd_fpk/klu.hpp"

namespace fpkcheck::fd_fpk {

double stationarity_residual(const SparseColumns& matrix, const Eigen::VectorXd& averages) {
  return (matrix * averages).lpNorm<1>() / averages.lpNorm<1>();
}

std::optional<Eigen::VectorXd> null_vector(const SparseColumns& matrix, const Grid& grid,
                                           const Eigen::VectorXd& start) {
  // Each iteration shrinks a mode that decays at rate a by shift/a; the slowest decays at about c.
  constexpr double kShift = 1e-8;
  constexpr int kIterations = 3;
  SparseColumns unit(matrix.rows(), matrix.cols());
  unit.setIdentity();
  const SparseColumns shifted = matrix - kShift * unit;
  const KluFactorisation factors(shifted);
  if (!factors.succeeded()) return std::nullopt;
  Eigen::VectorXd averages = start;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    factors.solve_in_place(averages);
    averages /= averages.sum() * grid.cell_area();
    if (!averages.allFinite()) return std::nullopt;
  }
  return averages;
}

}  // namespace fpkcheck::fd_fpk
