#include "backward/residual/density_residuals.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "backward/control/control_function_fit.hpp"
#include "base/input_error.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::backward {
namespace {

// Weight of the jumps at the wall (ControlFitProblem::wall_weight), equal to the weight for four
// samples per radian of the undamped motion. The corrected moments hardly depend on the weight of
// the jumps.
constexpr double kWallWeight = 4;

const ControlCells& cells_for(const problem::ProblemFeatures& features) {
  if (features.wells < 2) return DensityResiduals::kCells;
  return features.noise ? DensityResiduals::kWellCells : DensityResiduals::kSharpWellCells;
}

// Assumed ratio of local error to L1 error of a density where the fit does not resolve the backward
// equation. Errors concentrate in such regions.
constexpr double kConcentration = 10;
// L1 distance of disjoint densities, which is also the largest error (E_p - E)[e] in units of the
// unresolved residual
constexpr double kDisjointL1 = 2;

// Largest contrast for which an error estimate is stated. The limit is from tests with random
// problems with wells (RandomWells in tests/backward/residual), in which the well probabilities had
// an error d. At contrasts above 0.65 the error estimate was below the true L1 error 2 d.
constexpr double kMaxContrast = 0.5;

/// Returns the total error t of a density, which solves t = found + min(kConcentration t,
/// kDisjointL1) unresolved + contrast t. An error d <= t/2 of the well probabilities contributes 2
/// d contrast to (E_p - E)[e]. The error is infinite if the residuals do not determine the well
/// probabilities.
double total_error(const ErrorComponents& error) {
  if (error.contrast > kMaxContrast) return std::numeric_limits<double>::infinity();
  const double of_wells = 1 - error.contrast;
  const double most = (error.found + kDisjointL1 * error.unresolved) / of_wells;
  const double left = of_wells - kConcentration * error.unresolved;
  return left > 0 ? std::min(most, error.found / left) : most;
}

}  // namespace

std::optional<transform::ErrorEstimate> DensityErrors::error_estimate() const {
  transform::ErrorEstimate result{.y_l1 = kSubBinFactor * total_error(y_l1),
                                  .ydot_l1 = kSubBinFactor * total_error(ydot_l1),
                                  .moments = {}};
  if (std::max(result.y_l1, result.ydot_l1) >= kDisjointL1) return std::nullopt;
  const double most = std::max(result.y_l1, result.ydot_l1);
  const double share = std::min(kConcentration * most, kDisjointL1);
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    const auto moment = transform::kMoments[k].moment;
    result.moments.*moment =
        std::abs(error.*moment) + share * unresolved[k] + most / 2 * well_residual_contrasts[k];
  }
  return result;
}

DensityResiduals::DensityResiduals(const problem::Problem& problem)
    : DensityResiduals(problem, cells_for(problem::problem_features(problem))) {}

DensityResiduals::DensityResiduals(const problem::Problem& problem, const ControlCells& cells)
    : residuals_(problem, control_splines(problem, cells, CellWidths::narrower_at_walls)),
      functions_(goal_functions(residuals_.y(), residuals_.v(), problem.frame)) {
  assert(residuals_unsupported_reason(problem).empty());
  const ControlFitProblem fit =
      control_function_fit(problem, residuals_.y(), residuals_.v(),
                           kWallWeight * problem::motion_scales(problem).frequency);
  h_ = fit_control_functions(fit, functions_.all);
  unresolved_ = UnresolvedResidual(fit, functions_.all, h_);
}

Eigen::MatrixXd DensityResiduals::backward_solution(Eigen::Index goal_function) const {
  return h_.coefficients.col(goal_function).reshaped<Eigen::RowMajor>(y().size(), v().size());
}

DensityErrors DensityResiduals::estimate_errors(const transform::Density& density) const {
  const DensityIntegrals weak = residuals_(density);
  DensityErrors result{.mass = weak.mass,
                       .corrected = weak.moments,
                       .error = {},
                       .contributions = {},
                       .unresolved = {},
                       .well_residual_contrasts = {},
                       .y_l1 = {},
                       .ydot_l1 = {}};
  const Eigen::VectorXd errors =
      -(h_.coefficients.transpose() * weak.residuals.reshaped<Eigen::RowMajor>().eval());
  const Eigen::VectorXd unresolved = unresolved_.mean_residuals(weak);
  const Eigen::VectorXd& well_residual_contrasts = unresolved_.well_residual_contrasts();
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    const Eigen::MatrixXd h = backward_solution(static_cast<Eigen::Index>(k));
    const double mean = h.cwiseProduct(weak.means).sum();
    result.contributions[k] = -((h.array() - mean) * weak.residuals.array()).matrix();
    const auto moment = transform::kMoments[k].moment;
    result.error.*moment = result.contributions[k].sum();
    result.corrected.*moment -= result.error.*moment;
    result.unresolved[k] = unresolved(static_cast<Eigen::Index>(k));
    result.well_residual_contrasts[k] = well_residual_contrasts(static_cast<Eigen::Index>(k));
  }
  const auto in_bins = [&](int first, int count) {
    return ErrorComponents{errors.segment(first, count).cwiseAbs().sum(),
                           unresolved.segment(first, count).sum(),
                           well_residual_contrasts.segment(first, count).sum() / 2};
  };
  result.y_l1 = in_bins(functions_.moments, functions_.y_bins);
  result.ydot_l1 = in_bins(functions_.moments + functions_.y_bins, functions_.v_bins);
  return result;
}

Eigen::MatrixXd DensityResiduals::contributions_per_cell(const Eigen::MatrixXd& contributions,
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
  const Eigen::MatrixXd in_cells = spline_fractions_in_cells(y(), y_edges) * contributions *
                                   spline_fractions_in_cells(v(), v_edges).transpose();
  return inverse_widths(y_edges).asDiagonal() * in_cells * inverse_widths(v_edges).asDiagonal();
}

std::string residuals_unsupported_reason(const problem::Problem& problem) {
  if (std::string why = problem::polynomial_method_unsupported_reason(problem); !why.empty())
    return why;
  const problem::ProblemFeatures features = problem::problem_features(problem);
  if (features.rests_in_contact) {
    return "the mass comes to rest at a wall: residuals of a density do not contain the atom";
  }
  if (features.collapse) {
    return "impacts accumulate at a wall (r <= 0.163 under noise): the impact law does not define "
           "how the mass leaves the wall";
  }
  return {};
}

Eigen::MatrixXd spline_fractions_in_cells(const numerics::QuinticBSplines& splines,
                                          std::span<const double> edges) {
  if (edges.size() < 2 ||
      std::ranges::adjacent_find(edges, std::greater_equal<>()) != edges.end()) {
    throw InputError("the cell edges of a map do not increase");
  }
  // Three Gauss points are exact, since the splines are polynomials of degree 5 between breaks and
  // edges.
  std::vector<double> cuts(splines.breaks());
  std::ranges::copy_if(edges, std::back_inserter(cuts),
                       [&](double x) { return splines.begin() < x && x < splines.end(); });
  std::ranges::sort(cuts);
  Eigen::MatrixXd fractions = Eigen::MatrixXd::Zero(std::ssize(edges) - 1, splines.size());
  const auto [points, weights] = numerics::composite_gauss_rule<3>(cuts);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto cell = std::ranges::upper_bound(edges, points[n]) - edges.begin() - 1;
    if (cell < 0 || cell >= fractions.rows()) continue;
    const auto b = splines.values_and_slopes(points[n]);
    for (int l = 0; l <= numerics::QuinticBSplines::kDegree; ++l) {
      fractions(cell, b.first + l) += weights(static_cast<Eigen::Index>(n)) * b.value[l];
    }
  }
  // The integral of a B-spline of degree n is the width of the support divided by n + 1 (de Boor).
  for (int i = 0; i < splines.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& knots = splines.knots();
    fractions.col(i) *= (numerics::QuinticBSplines::kDegree + 1) /
                        (knots[k + numerics::QuinticBSplines::kDegree + 1] - knots[k]);
  }
  return fractions;
}

}  // namespace fpkcheck::backward
