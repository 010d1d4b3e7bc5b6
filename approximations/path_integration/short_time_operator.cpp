#include "approximations/path_integration/short_time_operator.hpp"

#include <Spectra/GenEigsSolver.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::path_integration {
namespace {

using Eigen::MatrixXd;

// The operator of the time `steps` T, with the interface that Spectra requires.
class RepeatedOperator {
 public:
  using Scalar = double;

  RepeatedOperator(const ShortTimeOperator& one_step, Eigen::Index velocities, int steps)
      : one_step_(one_step), velocities_(velocities), steps_(steps) {}

  Eigen::Index rows() const { return one_step_.size(); }
  Eigen::Index cols() const { return one_step_.size(); }
  void perform_op(const double* in, double* out) const {
    MatrixXd values = Eigen::Map<const MatrixXd>(in, velocities_, rows() / velocities_);
    for (int k = 0; k < steps_; ++k) one_step_.advance(values);
    Eigen::Map<MatrixXd>(out, values.rows(), values.cols()) = values;
  }

 private:
  const ShortTimeOperator& one_step_;
  Eigen::Index velocities_;
  int steps_;
};

}  // namespace

double PhasePlaneSplines::value(const MatrixXd& coefficients, double at_y, double at_v) const {
  const auto& basis_y = y.basis();
  const auto& basis_v = v.basis();
  if (at_y < basis_y.begin() || at_y > basis_y.end()) return 0;
  if (at_v < basis_v.begin() || at_v > basis_v.end()) return 0;
  const auto in_y = basis_y.values_and_slopes(at_y), in_v = basis_v.values_and_slopes(at_v);
  constexpr int kTaps = numerics::QuinticBSplines::kDegree + 1;
  const Eigen::Map<const Eigen::Vector<double, kTaps>> weights_y(in_y.value.data()),
      weights_v(in_v.value.data());
  return weights_v.dot(coefficients.block<kTaps, kTaps>(in_v.first, in_y.first) * weights_y);
}

double ShortTimeOperator::EarlierValue::of(const MatrixXd& coefficients) const {
  const double* column = coefficients.data() + first_y * coefficients.rows() + first_v;
  std::array<double, kTaps> over_y{};
  for (const double weight : y) {
    for (std::size_t k = 0; k < kTaps; ++k) over_y[k] += weight * column[k];
    column += coefficients.rows();
  }
  double sum = 0;
  for (std::size_t k = 0; k < kTaps; ++k) sum += v[k] * over_y[k];
  return sum;
}

ShortTimeOperator::ShortTimeOperator(const problem::Problem& problem,
                                     problem::DensityEquation equation,
                                     const PhasePlaneSplines& splines, double time_step,
                                     double max_motion_step)
    : splines_(splines), time_step_(time_step) {
  const bool depends_on_y = problem.noise_factor || problem.impulse_factor;
  for (const double y : splines.y.points()) {
    half_kicks_.push_back(kick_matrix(problem, equation, y, time_step / 2, splines.v));
    if (!depends_on_y) break;
  }
  earlier_values_.reserve(static_cast<std::size_t>(size()));
  for (const double y : splines.y.points()) {
    for (const double v : splines.v.points())
      earlier_values_.push_back(
          earlier_value(earlier_state(problem.system, y, v, time_step, max_motion_step)));
  }
}

ShortTimeOperator::EarlierValue ShortTimeOperator::earlier_value(const EarlierState& state) const {
  const auto &basis_y = splines_.y.basis(), &basis_v = splines_.v.basis();
  // Mass from outside of the range is neglected. The comparison is false for numbers that are not
  // finite.
  const bool is_inside = state.y >= basis_y.begin() && state.y <= basis_y.end() &&
                         state.v >= basis_v.begin() && state.v <= basis_v.end() &&
                         std::isfinite(state.growth);
  if (!is_inside) return {};
  const auto in_y = basis_y.values_and_slopes(state.y), in_v = basis_v.values_and_slopes(state.v);
  EarlierValue result{in_v.first, in_y.first, in_v.value, in_y.value};
  for (double& weight : result.y) weight *= state.growth;
  return result;
}

MatrixXd ShortTimeOperator::kicked_values(const MatrixXd& values) const {
  if (half_kicks_.size() == 1) return half_kicks_.front() * values;
  MatrixXd kicked(values.rows(), values.cols());
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    kicked.col(j).noalias() = half_kicks_[static_cast<std::size_t>(j)] * values.col(j);
  return kicked;
}

void ShortTimeOperator::advance(MatrixXd& values) const {
  const MatrixXd coefficients = splines_.coefficients(kicked_values(values));
  for (std::size_t k = 0; k < earlier_values_.size(); ++k)
    values.data()[k] = earlier_values_[k].of(coefficients);
  values = kicked_values(values);
}

StationarySpline stationary_spline(const ShortTimeOperator& short_time_operator,
                                   const PhasePlaneSplines& splines, const MatrixXd& start,
                                   double duration) {
  const int steps =
      std::max(1, static_cast<int>(std::lround(duration / short_time_operator.time_step())));
  RepeatedOperator repeated(short_time_operator, start.rows(), steps);
  // Larger Krylov spaces need fewer restarts and more time for orthogonalisation.
  constexpr int kKrylovVectors = 12, kMaxRestarts = 200;
  Spectra::GenEigsSolver<RepeatedOperator> solver(repeated, 1, kKrylovVectors);
  solver.init(start.data());
  StationarySpline result;
  const auto count =
      solver.compute(Spectra::SortRule::LargestReal, kMaxRestarts, kEigenvectorTolerance);
  if (count == 0) return result;
  const Eigen::VectorXd vector = solver.eigenvectors().col(0).real();
  result.values = Eigen::Map<const MatrixXd>(vector.data(), start.rows(), start.cols());
  result.coefficients = splines.coefficients(result.values);
  const double mass = splines.integral(result.coefficients);
  result.values /= mass;
  result.coefficients /= mass;
  result.growth_rate =
      std::log(solver.eigenvalues()(0).real()) / (steps * short_time_operator.time_step());
  result.has_converged = std::isfinite(mass) && mass != 0;
  return result;
}

}  // namespace fpkcheck::path_integration
