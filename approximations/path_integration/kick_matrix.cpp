#include "approximations/path_integration/kick_matrix.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "numerics/linear_algebra/factorisations.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::path_integration {
namespace {

using Eigen::MatrixXd;
using Splines = numerics::QuinticBSplines;

// Adds weight * B_j(v) to row i, for all B-splines j.
void add_basis_values(const Splines& basis, double v, double weight, MatrixXd& matrix,
                      Eigen::Index i) {
  if (v < basis.begin() || v > basis.end()) return;
  const auto [first, value, slope] = basis.values_and_slopes(v);
  for (int k = 0; k <= Splines::kDegree; ++k)
    matrix(i, first + k) += weight * value[static_cast<std::size_t>(k)];
}

// Returns the ends of quadrature panels: the break points of the law and of the spline of
// v - scale Y, and further points at a distance of at most one standard deviation.
std::vector<double> panel_ends(const problem::ImpulseLaw& law, const Splines& basis, double v,
                               double scale) {
  const auto pieces = law.amplitude_density_breakpoints();
  std::vector<double> ends = pieces;
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    const double count =
        std::ceil((pieces[k + 1] - pieces[k]) / law.amplitude_standard_deviation());
    for (double c = 1; c < count; ++c)
      ends.push_back(std::lerp(pieces[k], pieces[k + 1], c / count));
  }
  for (const double knot : basis.breaks()) {
    const double amplitude = (v - knot) / scale;
    if (amplitude > pieces.front() && amplitude < pieces.back()) ends.push_back(amplitude);
  }
  std::ranges::sort(ends);
  return ends;
}

// Returns the matrix that computes the values E[p(v_i - scale Y)] from the values p(v_i).
MatrixXd expectation_matrix(const problem::ImpulseLaw& law, double scale,
                            const SplineInterpolation& interpolation) {
  const Splines& basis = interpolation.basis();
  const Eigen::Index size = interpolation.size();
  MatrixXd from_coefficients = MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double v = interpolation.points()[static_cast<std::size_t>(i)];
    for (const auto& atom : law.amplitude_atoms())
      add_basis_values(basis, v - scale * atom.amplitude, atom.probability, from_coefficients, i);
    if (!law.amplitude_atoms().empty()) continue;
    constexpr unsigned kPoints = 8;
    const auto rule = numerics::composite_gauss_rule<kPoints>(panel_ends(law, basis, v, scale));
    for (Eigen::Index q = 0; q < rule.size(); ++q) {
      const double amplitude = rule.points[static_cast<std::size_t>(q)];
      add_basis_values(basis, v - scale * amplitude, rule.weights(q) * law.density(amplitude),
                       from_coefficients, i);
    }
  }
  return from_coefficients * interpolation.coefficients_from_values();
}

// Returns exp(mean (J - 1)) = sum_k e^-mean mean^k/k! J^k: the number k of impulses has a Poisson
// distribution.
MatrixXd compound_poisson_matrix(const MatrixXd& jumps, double mean) {
  // exp(mean (J - 1)) is the square of exp(mean/2 (J - 1)); the factor exp(-mean) of the first term
  // would underflow for large means.
  constexpr double kRounding = 1e-16, kLargestMean = 16;
  if (mean > kLargestMean) {
    const MatrixXd root = compound_poisson_matrix(jumps, mean / 2);
    return root * root;
  }
  MatrixXd term = MatrixXd::Identity(jumps.rows(), jumps.cols()) * std::exp(-mean);
  MatrixXd sum = term;
  for (double k = 1, weight = std::exp(-mean); k < mean || weight > kRounding; ++k) {
    weight *= mean / k;
    term = term * jumps * (mean / k);
    sum += term;
  }
  return sum;
}

}  // namespace

SplineInterpolation::SplineInterpolation(const std::vector<double>& breaks)
    : basis_(numerics::knots_from_breaks(breaks)), integrals_(basis_.size()) {
  const auto& knots = basis_.knots();
  MatrixXd values = MatrixXd::Zero(size(), size());
  for (int i = 0; i < size(); ++i) {
    const auto first = knots.begin() + i;
    constexpr int kDegree = Splines::kDegree;
    integrals_(i) = (first[kDegree + 1] - first[0]) / (kDegree + 1);
    double sum = 0;
    for (int k = 1; k <= kDegree; ++k) sum += first[k];
    points_.push_back(std::clamp(sum / kDegree, basis_.begin(), basis_.end()));
    add_basis_values(basis_, points_.back(), 1, values, i);
  }
  const numerics::LuFactors factors(values);
  coefficients_from_values_.resize(size(), size());
  for (int i = 0; i < size(); ++i)
    coefficients_from_values_.col(i) = factors.solve(Eigen::VectorXd::Unit(size(), i));
}

MatrixXd kick_matrix(const problem::Problem& problem, problem::DensityEquation equation, double y,
                     double duration, const SplineInterpolation& interpolation) {
  const auto& impulses = problem.impulses;
  const double factor = problem.impulse_factor ? (*problem.impulse_factor)(y, 0) : 1;
  double variance = 2 * problem::noise_diffusion_coefficient(problem, y, 0) * duration;
  double mean = 0;
  MatrixXd matrix = MatrixXd::Identity(interpolation.size(), interpolation.size());
  if (impulses.is_acting() && equation == problem::DensityEquation::white) {
    variance += impulses.intensity() * factor * factor * duration;
    mean = impulses.rate_times_moment(1) * factor * duration;
  } else if (impulses.is_acting() && factor != 0) {
    matrix =
        compound_poisson_matrix(expectation_matrix(impulses.amplitude_law(), factor, interpolation),
                                impulses.arrival_rate() * duration);
  }
  if (variance > 0) {
    const problem::ImpulseLaw noise(problem::GaussianLaw{mean, std::sqrt(variance)});
    matrix = expectation_matrix(noise, 1, interpolation) * matrix;
  }
  return matrix;
}

}  // namespace fpkcheck::path_integration
