#include "fd_fpk/rightmost_eigenvalue.hpp"

#include <Spectra/GenEigsRealShiftSolver.h>
#include <Spectra/GenEigsSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fd_fpk/klu.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using Complex = std::complex<double>;

constexpr double kTolerance = 1e-9;  // of a Ritz value's residual, relative
constexpr long kRestarts = 20;
constexpr long kTestRestarts = 6;
constexpr int kNearest = 20;
constexpr int kSpare = 3;  // eigenvalues that a test asks for beyond those known
constexpr int kBasis = 60;
// Closer than this, in units of the rates at hand, two Ritz values are one eigenvalue.
constexpr double kSame = 1e-7;

// (L - sigma)^-1 as Spectra wants it.
class ShiftedInverse {
 public:
  using Scalar = double;

  explicit ShiftedInverse(SparseColumns matrix) : matrix_(std::move(matrix)) {}

  Eigen::Index rows() const { return matrix_.rows(); }
  Eigen::Index cols() const { return matrix_.cols(); }

  void set_shift(double sigma) {
    SparseColumns unit(rows(), rows());
    unit.setIdentity();
    // The pattern must not depend on the shift: KLU keeps its ordering.
    const SparseColumns shifted = matrix_ - sigma * unit;
    ++factorisations_;
    if (!klu_.factor(shifted)) throw std::runtime_error(klu_.failure());
  }

  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd> result(out, rows());
    result = Eigen::Map<const Eigen::VectorXd>(in, rows());
    klu_.solve_in_place(result);
    ++solves_;
  }

  long factorisations() const { return factorisations_; }
  long solves() const { return solves_; }

 private:
  SparseColumns matrix_;
  KluFactorisation klu_;
  long factorisations_ = 0;
  mutable long solves_ = 0;
};

// C = 1 + 2 (sigma - m) (L - sigma)^-1.
class CayleyTransform {
 public:
  using Scalar = double;

  CayleyTransform(const ShiftedInverse& inverse, double sigma, double m)
      : inverse_(inverse), sigma_(sigma), width_(2 * (sigma - m)) {}

  Eigen::Index rows() const { return inverse_.rows(); }
  Eigen::Index cols() const { return inverse_.cols(); }

  void perform_op(const double* in, double* out) const {
    inverse_.perform_op(in, out);
    Eigen::Map<Eigen::VectorXd> result(out, rows());
    result = Eigen::Map<const Eigen::VectorXd>(in, rows()) + width_ * result;
  }

  Complex eigenvalue_of_l(Complex of_c) const { return sigma_ + width_ / (of_c - 1.0); }

 private:
  const ShiftedInverse& inverse_;
  double sigma_;
  double width_;
};

struct EigenPairs {
  std::vector<Complex> values;
  Eigen::MatrixXcd vectors;  // shape (size, values)
};

// What has converged of the eigenvalues that the solver was asked for.
template <class Solver>
EigenPairs solve(Solver& solver, long restarts) {
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, restarts, kTolerance);
  const Eigen::VectorXcd values = solver.eigenvalues();
  return {{values.begin(), values.end()}, solver.eigenvectors()};
}

// Both lists as one without repetitions, the rightmost first, of each conjugate pair the one above
// the real axis.
EigenPairs from_the_right(const EigenPairs& a, const EigenPairs& b, double unit) {
  struct Pair {
    Complex value;
    Eigen::VectorXcd vector;
  };
  std::vector<Pair> all;
  for (const EigenPairs* pairs : {&a, &b}) {
    for (std::size_t k = 0; k < pairs->values.size(); ++k) {
      const Complex value = pairs->values[k];
      const Eigen::VectorXcd vector = pairs->vectors.col(static_cast<Eigen::Index>(k));
      const Pair upper = value.imag() < 0 ? Pair{std::conj(value), vector.conjugate()}
                                          : Pair{{value.real(), std::abs(value.imag())}, vector};
      if (std::ranges::none_of(all, [&](const Pair& known) {
            return std::abs(known.value - upper.value) < kSame * unit;
          })) {
        all.push_back(upper);
      }
    }
  }
  std::ranges::sort(all, std::ranges::greater{},
                    [](const Pair& pair) { return pair.value.real(); });
  EigenPairs sorted{{}, Eigen::MatrixXcd(a.vectors.rows(), all.size())};
  for (const Pair& pair : all) {
    sorted.vectors.col(static_cast<Eigen::Index>(sorted.values.size())) = pair.vector;
    sorted.values.push_back(pair.value);
  }
  return sorted;
}

// Eigenvalues of L that the first `count` of a list stand for.
int with_conjugates(const EigenPairs& pairs, int count) {
  int all = 0;
  for (int k = 0; k < count; ++k) all += pairs.values[k].imag() > 0 ? 2 : 1;
  return all;
}

}  // namespace

RightmostEigenvalues rightmost_eigenvalues(const FokkerPlanckOperator& op, double growth,
                                           double frequency, int count) {
  constexpr double kRightOfGrowth = 0.05;
  constexpr double kLeftOfLast = 0.05;
  constexpr double kFastest = 8;
  constexpr int kMostTests = 4;
  ShiftedInverse inverse(op.assembled());
  RightmostEigenvalues result;
  try {
    const double unit = std::max(growth, frequency);
    // A transform as wide as the modes turn fast ranks them by their real parts.
    const double width = std::max(growth, kFastest * frequency);
    Spectra::GenEigsRealShiftSolver<ShiftedInverse> nearest(
        inverse, kNearest, kBasis, std::max(growth, 0.0) + kRightOfGrowth * unit);
    EigenPairs found = from_the_right(solve(nearest, kRestarts), {}, unit);
    if (static_cast<int>(found.values.size()) <= count) {
      throw std::runtime_error(fmt::format(
          "Arnoldi's iteration found {} eigenvalues of {} in {} restarts (take another grid)",
          found.values.size(), kNearest, kRestarts));
    }
    for (int test = 0, confirmed = 0; confirmed < count; ++test) {
      if (test == kMostTests) {
        throw std::runtime_error("the rightmost eigenvalues did not settle (take another grid)");
      }
      const double last = found.values[count - 1].real();
      const double next = found.values[count].real();
      const double m = std::max((last + next) / 2, last - kLeftOfLast * unit);
      inverse.set_shift(m + width);
      CayleyTransform cayley(inverse, m + width, m);
      Spectra::GenEigsSolver<CayleyTransform> furthest(
          cayley, with_conjugates(found, count) + kSpare, kBasis);
      EigenPairs right = solve(furthest, kTestRestarts);
      for (auto& value : right.values) value = cayley.eigenvalue_of_l(value);
      const EigenPairs all = from_the_right(found, right, unit);
      for (confirmed = 0; confirmed < count; ++confirmed) {
        if (all.values[confirmed] != found.values[confirmed]) break;
      }
      found = all;
    }
    for (int k = 0; k < count; ++k) {
      const Eigen::VectorXcd v = found.vectors.col(k).normalized();
      const Eigen::VectorXcd lv =
          (op * v.real()).cast<Complex>() + Complex(0, 1) * (op * v.imag()).cast<Complex>();
      result.residual = std::max(result.residual, (lv - found.values[k] * v).norm());
      if (k == 0) result.vector = v;
    }
    result.values = {found.values.begin(), found.values.begin() + count};
  } catch (const std::exception& error) {
    result.failure = error.what();
  }
  result.factorisations = inverse.factorisations();
  result.solves = inverse.solves();
  return result;
}

}  // namespace fpkcheck::fd_fpk
