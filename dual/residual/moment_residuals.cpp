#include "dual/residual/moment_residuals.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "dual/control/control_functions.hpp"
#include "dual/residual/spline_shares.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::dual {
namespace {

// The jumps at the wall count as if in samples of the density four times a radian of the
// linearised oscillator; the corrected moments hardly depend on it.
constexpr double kWallWeight = 4;

std::function<double(double)> power_of(int n) {
  return [n](double x) { return std::pow(x, n); };
}

/// In the order of transform::kMoments.
std::vector<SeparableFunction> moment_functions() {
  std::vector<SeparableFunction> functions;
  for (const int n : {1, 2, 4}) functions.push_back({power_of(n), power_of(0)});
  for (const int n : {1, 2, 4}) functions.push_back({power_of(0), power_of(n)});
  return functions;
}

WeakResiduals usual_residuals(const problem::Problem& problem, const ControlCells& cells) {
  ControlSplines splines = usual_splines(problem, cells);
  return {problem, std::move(splines.y), std::move(splines.v)};
}

}  // namespace

MomentResiduals::MomentResiduals(const problem::Problem& problem, const ControlCells& cells)
    : residuals_(usual_residuals(problem, cells)) {
  const double frequency = std::sqrt(problem::equivalent_linearisation(problem).stiffness);
  const auto fitted = control_functions(usual_control(problem, y(), v(), kWallWeight * frequency),
                                        moment_functions());
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    h_[k] = fitted.coefficients.col(static_cast<Eigen::Index>(k))
                .reshaped<Eigen::RowMajor>(y().size(), v().size());
  }
}

WeightedResiduals MomentResiduals::of(const transform::Density& density) const {
  const WeakForm weak = residuals_(density);
  WeightedResiduals result{
      .mass = weak.mass, .corrected = weak.moments, .error = {}, .contributions = {}};
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    const double mean = h_[k].cwiseProduct(weak.means).sum();
    result.contributions[k] = -((h_[k].array() - mean) * weak.residuals.array()).matrix();
    const auto moment = transform::kMoments[k].moment;
    result.error.*moment = result.contributions[k].sum();
    result.corrected.*moment -= result.error.*moment;
  }
  return result;
}

Eigen::MatrixXd MomentResiduals::spread(const Eigen::MatrixXd& contributions,
                                        std::span<const double> y_edges,
                                        std::span<const double> v_edges) const {
  const auto inverse_widths = [](std::span<const double> edges) {
    Eigen::VectorXd inverse(std::ssize(edges) - 1);
    for (Eigen::Index k = 0; k < inverse.size(); ++k) {
      const auto at = static_cast<std::size_t>(k);
      inverse(k) = 1 / (edges[at + 1] - edges[at]);
    }
    return inverse;
  };
  const Eigen::MatrixXd in_cells =
      spline_shares(y(), y_edges) * contributions * spline_shares(v(), v_edges).transpose();
  return inverse_widths(y_edges).asDiagonal() * in_cells * inverse_widths(v_edges).asDiagonal();
}

}  // namespace fpkcheck::dual
