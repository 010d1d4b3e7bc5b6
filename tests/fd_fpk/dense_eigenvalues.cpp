#include "dense_eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <functional>

namespace fpkcheck::tests {

std::vector<std::complex<double>> dense_eigenvalues(const Eigen::SparseMatrix<double>& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(matrix), false);
  std::vector<std::complex<double>> upper;
  for (const auto value : solver.eigenvalues()) {
    if (value.imag() >= 0) upper.push_back(value);
  }
  std::ranges::sort(upper, std::ranges::greater{}, [](auto z) { return z.real(); });
  return upper;
}

}  // namespace fpkcheck::tests
