#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"

#include <Spectra/GenEigsSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/linear/klu.hpp"

namespace fpkcheck::fd_fpk {

NullVectorResult find_null_vector(const FokkerPlanckOperator& op, Preconditioner& preconditioner,
                                  const Eigen::VectorXd& initial_averages,
                                  const base::Deadline& deadline) {
  constexpr double kTolerance = 1e-13;
  if (!preconditioner.factorise_stationary())
    return {std::nullopt, 0, preconditioner.failure_reason()};
  const auto times = [&](const Eigen::VectorXd& p) { return op * p; };
  const auto approximate_solve = [&](Eigen::Ref<Eigen::VectorXd> b) {
    preconditioner.solve_in_place(b);
  };
  const base::Stopwatch stopwatch;
  auto [correction, iterations, failure] = solve_by_gmres(
      times, approximate_solve, -(op * initial_averages), op.areas, kTolerance, deadline);
  const double seconds = stopwatch.seconds();
  if (!correction) return {std::nullopt, iterations, failure, seconds};
  Eigen::VectorXd averages = initial_averages + *correction;
  averages /= op.total_mass(averages);
  return {std::move(averages), iterations, "", seconds};
}

NullVectorResult find_null_vector_by_inverse_iteration(const FokkerPlanckOperator& op,
                                                       const Eigen::VectorXd& initial_averages,
                                                       double frequency) {
  // shift that makes the singular Fokker-Planck matrix nonsingular, in units of the oscillator's
  // frequency
  constexpr double kShift = 1e-7;
  constexpr int kIterations = 4;
  constexpr double kResidual = 1e-8;
  KluFactorisation klu;
  if (!klu.factorise(scale_and_shift_matrix(1, op.assembled_matrix(), -kShift * frequency)))
    return {std::nullopt, 0, klu.failure_reason()};
  Eigen::VectorXd averages = initial_averages;
  for (int k = 0; k < kIterations; ++k) {
    klu.solve_in_place(averages);
    averages /= op.total_mass(averages);
  }
  const double residual = op.stationarity_residual(averages) / frequency;
  if (!(residual < kResidual)) {
    return {std::nullopt, 0,
            fmt::format("inverse iteration did not converge: residual {:.1e}", residual)};
  }
  return {std::move(averages), 0};
}

namespace {

using Complex = std::complex<double>;

constexpr double kTolerance = 1e-9;  // tolerance of the relative residual of a Ritz value
constexpr long kRestarts = 20;
constexpr long kTestRestarts = 6;
constexpr int kNearest = 20;
// Number of additional eigenvalues that each check for missed eigenvalues requests
constexpr int kSpare = 3;
constexpr int kBasis = 60;
// Distance below which two Ritz values count as one eigenvalue, in units of the growth rate of the
// excitation or of the oscillator's frequency. An eigenvalue of a non-normal matrix is accurate
// only to the residual of the eigenpair times the condition number of the eigenvalue. For the Pade
// scheme of case 1 the Arnoldi method found the eigenvalue 0 twice, with a difference of 2e-7.
constexpr double kSame = 1e-6;

// The linear operator (L - sigma)^-1 with a real shift sigma, computed by KLU factors of the matrix
// L - sigma.
class ShiftedOperatorInverse {
 public:
  explicit ShiftedOperatorInverse(SparseColumnMatrix matrix) : matrix_(std::move(matrix)) {}

  Eigen::Index size() const { return matrix_.rows(); }

  void set_shift(double sigma) {
    // The positions of nonzero entries must not depend on the shift sigma, since KLU reuses the
    // ordering.
    ++factorisations_;
    if (!klu_.factorise(scale_and_shift_matrix(1, matrix_, -sigma)))
      throw std::runtime_error(klu_.failure_reason());
    sigma_ = sigma;
  }
  double shift() const { return sigma_; }

  void apply_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
    klu_.solve_in_place(b);
    ++solves_;
  }

  long factorisation_count() const { return factorisations_; }
  long solve_count() const { return solves_; }

 private:
  SparseColumnMatrix matrix_;
  KluFactorisation klu_;
  double sigma_ = 0;
  long factorisations_ = 0;
  mutable long solves_ = 0;
};

// The spectral transform T = constant + factor (L - sigma)^-1 of the operator L, with the interface
// that Spectra requires.
class SpectralTransform {
 public:
  using Scalar = double;

  /// Constructs the spectral transform T = (L - sigma)^-1 of the operator L.
  explicit SpectralTransform(const ShiftedOperatorInverse& inverse)
      : SpectralTransform(inverse, 0, 1) {}
  /// Returns the Cayley transform 1 + 2 (sigma - m) (L - sigma)^-1 of the operator L.
  static SpectralTransform cayley_transform(const ShiftedOperatorInverse& inverse, double m) {
    return {inverse, 1, 2 * (inverse.shift() - m)};
  }

  Eigen::Index rows() const { return inverse_.size(); }
  Eigen::Index cols() const { return inverse_.size(); }

  void perform_op(const double* in, double* out) const {
    const Eigen::Map<const Eigen::VectorXd> vector(in, rows());
    Eigen::Map<Eigen::VectorXd> result(out, rows());
    result = vector;
    inverse_.apply_in_place(result);
    result = constant_ * vector + factor_ * result;
  }

  Complex untransform_eigenvalue(Complex transformed) const {
    return inverse_.shift() + factor_ / (transformed - constant_);
  }

 private:
  SpectralTransform(const ShiftedOperatorInverse& inverse, double constant, double factor)
      : inverse_(inverse), constant_(constant), factor_(factor) {}

  const ShiftedOperatorInverse& inverse_;
  double constant_;
  double factor_;
};

struct EigenvaluesAndVectors {
  std::vector<Complex> values;
  Eigen::MatrixXcd vectors;  // one eigenvector per column, shape (size, number of values)
};

// Returns the converged eigenpairs of L for the `count` largest eigenvalues of the transform.
EigenvaluesAndVectors largest_eigenpairs(SpectralTransform& transform, int count, long restarts) {
  Spectra::GenEigsSolver<SpectralTransform> solver(transform, count, kBasis);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, restarts, kTolerance);
  EigenvaluesAndVectors pairs{{}, solver.eigenvectors()};
  for (const Complex value : solver.eigenvalues()) {
    pairs.values.push_back(transform.untransform_eigenvalue(value));
  }
  return pairs;
}

// Returns the union of two lists of eigenpairs without duplicates, by decreasing real part. Of each
// conjugate pair the list contains only the eigenvalue in the upper half-plane.
EigenvaluesAndVectors merge_by_real_part(const EigenvaluesAndVectors& a,
                                         const EigenvaluesAndVectors& b, double unit) {
  struct Pair {
    Complex value;
    Eigen::VectorXcd vector;
  };
  std::vector<Pair> all;
  for (const EigenvaluesAndVectors* pairs : {&a, &b}) {
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
  EigenvaluesAndVectors sorted{{}, Eigen::MatrixXcd(a.vectors.rows(), all.size())};
  for (const Pair& pair : all) {
    sorted.vectors.col(static_cast<Eigen::Index>(sorted.values.size())) = pair.vector;
    sorted.values.push_back(pair.value);
  }
  return sorted;
}

// Returns the number of eigenvalues, including complex conjugates, that the first `count` entries
// of the list represent.
int count_with_conjugates(const EigenvaluesAndVectors& pairs, int count) {
  int all = 0;
  for (int k = 0; k < count; ++k) all += pairs.values[k].imag() > 0 ? 2 : 1;
  return all;
}

}  // namespace

RightmostEigenvalues find_rightmost_eigenvalues(const FokkerPlanckOperator& op,
                                                double excitation_growth_rate, double frequency,
                                                int count) {
  constexpr double kRightOfGrowth = 0.05;
  constexpr double kLeftOfLast = 0.05;
  constexpr double kFastest = 8;
  constexpr int kMostTests = 4;
  ShiftedOperatorInverse inverse(op.assembled_matrix());
  RightmostEigenvalues result;
  try {
    const double unit = std::max(excitation_growth_rate, frequency);
    // If the shift sigma of the Cayley transform exceeds the number m by at least the frequency of
    // every mode, the order of the transformed eigenvalues by modulus is the order of the
    // eigenvalues of L by real part.
    const double width = std::max(excitation_growth_rate, kFastest * frequency);
    inverse.set_shift(std::max(excitation_growth_rate, 0.0) + kRightOfGrowth * unit);
    SpectralTransform nearest(inverse);
    EigenvaluesAndVectors found =
        merge_by_real_part(largest_eigenpairs(nearest, kNearest, kRestarts), {}, unit);
    if (static_cast<int>(found.values.size()) <= count) {
      throw std::runtime_error(fmt::format(
          "Arnoldi iteration: {} of {} eigenvalues converged in {} restarts; use another grid",
          found.values.size(), kNearest, kRestarts));
    }
    for (int test = 0, confirmed = 0; confirmed < count; ++test) {
      if (test == kMostTests) {
        throw std::runtime_error(
            "the rightmost eigenvalues did not converge: every check found new "
            "eigenvalues; use another grid");
      }
      const double last = found.values[count - 1].real();
      const double next = found.values[count].real();
      const double m = std::max((last + next) / 2, last - kLeftOfLast * unit);
      inverse.set_shift(m + width);
      SpectralTransform cayley = SpectralTransform::cayley_transform(inverse, m);
      const EigenvaluesAndVectors right =
          largest_eigenpairs(cayley, count_with_conjugates(found, count) + kSpare, kTestRestarts);
      const EigenvaluesAndVectors all = merge_by_real_part(found, right, unit);
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
  result.factorisations = inverse.factorisation_count();
  result.solves = inverse.solve_count();
  return result;
}

}  // namespace fpkcheck::fd_fpk
