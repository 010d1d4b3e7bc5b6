#pragma once

#include <Eigen/SparseCore>
#include <complex>
#include <vector>

namespace fpkcheck::tests {

/// All eigenvalues on or above the real axis, by decreasing real part, by a dense solver. Compiled
/// once for all tests: the solver takes half a minute to compile.
std::vector<std::complex<double>> dense_eigenvalues(const Eigen::SparseMatrix<double>& matrix);

}  // namespace fpkcheck::tests
