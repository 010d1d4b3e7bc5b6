#include "fd_fpk/null_vector.hpp"

#include "fd_fpk/klu.hpp"

namespace fpkcheck::fd_fpk {

double stationarity_residual(const SparseColumns& matrix, const Eigen::VectorXd& averages) {
  return (matrix * averages).lpNorm<1>() / averages.lpNorm<1>();
}

NullVector null_vector(const SparseColumns& matrix, const Grid& grid, const Eigen::VectorXd& start,
                       double slowest_decay) {
  // Each iteration shrinks a mode that decays at rate a by shift/a.
  constexpr double kRelativeShift = 2e-7;
  constexpr int kIterations = 3;
  SparseColumns unit(matrix.rows(), matrix.cols());
  unit.setIdentity();
  const SparseColumns shifted = matrix - kRelativeShift * slowest_decay * unit;
  const KluFactorisation factors(shifted);
  if (!factors.succeeded()) return {std::nullopt, factors.failure()};
  Eigen::VectorXd averages = start;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    factors.solve_in_place(averages);
    averages /= averages.sum() * grid.cell_area();
    if (!averages.allFinite()) {
      return {std::nullopt, "inverse iteration for the null vector overflowed (take a finer grid)"};
    }
  }
  return {std::move(averages), ""};
}

}  // namespace fpkcheck::fd_fpk
