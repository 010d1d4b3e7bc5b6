#include "fd_fpk/functionals/reduced_resolvent.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace fpkcheck::fd_fpk {
namespace {

// Relative residuals of the linear systems of the first and of the last basis vectors. With the
// residual 1e-9 for all basis vectors the spectral densities of case1 change by a relative 1e-6 at
// most.
constexpr double kTolerance = 1e-8, kLargestTolerance = 1e-4;

}  // namespace

ReducedResolvent::ReducedResolvent(const ShiftedLinearSystem& system, const Eigen::VectorXd& b,
                                   Eigen::VectorXd stationary)
    : system_(system), stationary_(std::move(stationary)), norm_(b.norm()), basis_(b / norm_) {}

bool ReducedResolvent::add_krylov_basis_vectors(int count, const base::Deadline& deadline) {
  basis_.conservativeResize(Eigen::NoChange, size_ + count + 1);
  hessenberg_.conservativeResize(size_ + count + 1, size_ + count);
  const double tolerance = std::min(kTolerance / weight_of_last_, kLargestTolerance);
  for (const int end = size_ + count; size_ < end; ++size_) {
    auto solution = system_.solve(basis_.col(size_), tolerance, deadline, failure_);
    if (!solution) return false;
    if (stationary_.size() > 0)
      *solution -= system_.operator_without_shift().total_mass(*solution) * stationary_;
    hessenberg_.col(size_).setZero();
    hessenberg_.row(size_ + 1).setZero();
    // Classical Gram-Schmidt orthogonalisation, twice for orthogonality to rounding
    const auto known = basis_.leftCols(size_ + 1);
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd along = known.transpose() * *solution;
      *solution -= known * along;
      hessenberg_.col(size_).head(size_ + 1) += along;
    }
    const double rest = solution->norm();
    hessenberg_(size_ + 1, size_) = rest;
    basis_.col(size_ + 1) = *solution / rest;
  }
  return true;
}

Eigen::VectorXcd ReducedResolvent::transfer_function_values(const Eigen::VectorXd& functional,
                                                            const Eigen::VectorXcd& points) {
  // With Schur's form H = U T U^*, each point s needs the solution of one triangular system.
  const Eigen::MatrixXd h = hessenberg_.topLeftCorner(size_, size_);
  const Eigen::ComplexSchur<Eigen::MatrixXd> schur(h);
  const Eigen::MatrixXcd &t = schur.matrixT(), &u = schur.matrixU();
  const Eigen::VectorXcd of_w =
      u.transpose() *
      (basis_.leftCols(size_).transpose() * functional).cast<std::complex<double>>();
  const Eigen::VectorXcd right = norm_ * (u.adjoint() * h.col(0).cast<std::complex<double>>());
  Eigen::VectorXcd values(points.size());
  weight_of_last_ = 0;
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    Eigen::MatrixXcd matrix = (points(k) - system_.resolvent_shift()) * t;
    matrix.diagonal().array() += 1;
    const Eigen::VectorXcd solution = matrix.triangularView<Eigen::Upper>().solve(right);
    const std::complex<double> last = u.row(size_ - 1).transpose().cwiseProduct(solution).sum();
    weight_of_last_ = std::max(weight_of_last_, std::abs(last) / solution.norm());
    values(k) = solution.cwiseProduct(of_w).sum();
  }
  return values;
}

Eigen::VectorXd ReducedResolvent::shifted_solution(double s) const {
  const Eigen::MatrixXd h = hessenberg_.topLeftCorner(size_, size_);
  const Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Identity(size_, size_) - (system_.resolvent_shift() - s) * h;
  return basis_.leftCols(size_) * matrix.partialPivLu().solve(norm_ * h.col(0));
}

ReducedResolvent::Modes ReducedResolvent::reduced_model_modes(const Eigen::VectorXd& functional,
                                                              std::optional<int> basis_size) const {
  const int n = basis_size.value_or(size_);
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(hessenberg_.topLeftCorner(n, n));
  const Eigen::MatrixXcd vectors = eigen.eigenvectors();
  const Eigen::VectorXcd start = vectors.partialPivLu().solve(norm_ * Eigen::VectorXcd::Unit(n, 0));
  const Eigen::VectorXcd of_w =
      vectors.transpose() *
      (basis_.leftCols(n).transpose() * functional).cast<std::complex<double>>();
  return {.rates = system_.resolvent_shift() - eigen.eigenvalues().cwiseInverse().array(),
          .coefficients = of_w.cwiseProduct(start)};
}

}  // namespace fpkcheck::fd_fpk
