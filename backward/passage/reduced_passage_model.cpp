#include "backward/passage/reduced_passage_model.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cassert>
#include <complex>

namespace fpkcheck::backward {

void ReducedOrderPassageModel::add_basis_function(const BasisFunction& function) {
  assert(function.node_values.size() == node_count_);
  assert(function.functionals.size() == functional_count_);
  const Eigen::Index n = sources_.size();
  assert(!function.has_previous || n > 0);
  const double norm = function.node_values.norm();
  node_values_.conservativeResize(node_count_, n + 1);
  node_values_.col(n) = function.node_values / norm;
  functionals_.conservativeResize(functional_count_, n + 1);
  functionals_.col(n) = function.functionals / norm;
  images_.conservativeResizeLike(Eigen::MatrixXd::Zero(n + 1, n + 1));
  images_(n, n) = function.shift;
  if (function.has_previous) images_(n - 1, n) = -last_norm_ / norm;
  sources_.conservativeResize(n + 1);
  sources_(n) = function.source / norm;
  last_norm_ = norm;
}

ReducedOrderPassageModel::Modes ReducedOrderPassageModel::compute_modes() const {
  const Eigen::Index n = sources_.size();
  // With the orthonormal basis Q of V = Q R the projection is Q^T L Q = (R images - Q^T 1 sources)
  // R^-1, and a functional with the values f at the columns of V has the values f R^-1 at those of
  // Q.
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(node_values_);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  const Eigen::VectorXd one =
      (qr.householderQ().transpose() * Eigen::VectorXd::Ones(node_count_)).head(n);
  const auto times_inverse_of_r = [&](const Eigen::MatrixXd& matrix) -> Eigen::MatrixXd {
    return r.triangularView<Eigen::Upper>().solve<Eigen::OnTheRight>(matrix);
  };
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(times_inverse_of_r(r * images_ - one * sources_));
  const Eigen::MatrixXcd vectors = eigen.eigenvectors();
  const Eigen::VectorXcd of_one = vectors.partialPivLu().solve(one.cast<std::complex<double>>());
  Modes modes{eigen.eigenvalues(),
              (times_inverse_of_r(functionals_) * vectors) * of_one.asDiagonal()};
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!(modes.rates(k).real() < 0)) modes.coefficients.col(k).setZero();
  }
  return modes;
}

}  // namespace fpkcheck::backward
