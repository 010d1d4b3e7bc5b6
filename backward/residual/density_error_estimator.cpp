#include "backward/residual/density_error_estimator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "backward/control_variates/control_variate_fit.hpp"
#include "base/input_error.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::backward {
namespace {

// Weight of the jumps at the wall (ControlVariateFitProblem::wall_jump_weight), in units of the
// frequency of the motion: the optimal weight for four samples per radian of the motion. The
// corrected moments hardly depend on the weight of the jumps at the wall.
constexpr double kWallWeight = 4;

const ControlVariateCellCounts& select_cell_counts(const problem::ProblemFeatures& features) {
  if (features.wells < 2) return DensityErrorEstimator::kSingleWellCells;
  return features.noise ? DensityErrorEstimator::kMultipleWellCells
                        : DensityErrorEstimator::kMultipleWellCellsWithoutNoise;
}

// Assumed ratio of the local relative error of a density to its L1 error, in regions where the fit
// does not resolve the backward equation. Errors of densities concentrate in regions where the fit
// does not resolve the backward equation.
constexpr double kErrorConcentration = 10;
// L1 distance of disjoint densities, which is also the largest error (E_p - E)[e] in units of the
// residual e of the backward equation
constexpr double kDisjointL1 = 2;

// Largest well contrast (dependence of residuals on well probabilities) for which an error estimate
// is stated. The limit of the contrast is from random problems with wells (RandomWells in
// tests/backward/residual), in which the well probabilities had an error d. At well contrasts above
// 0.65 the error estimate was below the exact L1 error 2 d, with the error d of the well
// probabilities.
constexpr double kMaxWellContrast = 0.5;

/// Returns the L1 error estimate t of a marginal density, the solution of
///
///     t = dual_weighted_error + min(kErrorConcentration t, kDisjointL1) unresolved_residual
///         + well_contrast t.
///
/// An error d <= t/2 of the well probabilities contributes 2 d well_contrast to the unresolved
/// error (E_p - E)[e]. The L1 error estimate is infinite if the weak residuals do not determine the
/// well probabilities.
double total_l1_error(const L1ErrorComponents& error) {
  if (error.well_contrast > kMaxWellContrast) return std::numeric_limits<double>::infinity();
  const double well_factor = 1 - error.well_contrast;
  const double upper_estimate =
      (error.dual_weighted_error + kDisjointL1 * error.unresolved_residual) / well_factor;
  const double factor = well_factor - kErrorConcentration * error.unresolved_residual;
  return factor > 0 ? std::min(upper_estimate, error.dual_weighted_error / factor) : upper_estimate;
}

}  // namespace

std::optional<transform::ErrorEstimate> DensityErrorEstimates::error_estimate() const {
  transform::ErrorEstimate result{.y_l1 = kSubBinFactor * total_l1_error(y_l1),
                                  .ydot_l1 = kSubBinFactor * total_l1_error(ydot_l1),
                                  .moments = {}};
  if (std::max(result.y_l1, result.ydot_l1) >= kDisjointL1) return std::nullopt;
  const double max_l1 = std::max(result.y_l1, result.ydot_l1);
  const double unresolved_factor = std::min(kErrorConcentration * max_l1, kDisjointL1);
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    const auto moment = transform::kMoments[k].moment;
    result.moments.*moment = std::abs(moment_errors.*moment) +
                             unresolved_factor * unresolved_residuals[k] +
                             max_l1 / 2 * residual_differences_between_wells[k];
  }
  return result;
}

DensityErrorEstimator::DensityErrorEstimator(const problem::Problem& problem)
    : DensityErrorEstimator(problem, select_cell_counts(problem::problem_features(problem))) {}

DensityErrorEstimator::DensityErrorEstimator(const problem::Problem& problem,
                                             const ControlVariateCellCounts& cells)
    : weak_residual_integrator_(
          problem,
          make_control_splines(problem, cells, SplineCellWidthDistribution::narrower_at_walls)),
      goal_functions_(make_goal_functions(weak_residual_integrator_.y_splines(),
                                          weak_residual_integrator_.v_splines(), problem.frame)) {
  assert(residuals_unsupported_reason(problem).empty());
  const ControlVariateFitProblem fit = make_control_fit_problem(
      problem, weak_residual_integrator_.y_splines(), weak_residual_integrator_.v_splines(),
      kWallWeight * problem::motion_scales(problem).frequency);
  backward_solutions_ = fit_control_variate_functions(fit, goal_functions_.functions);
  unresolved_residual_ =
      BackwardEquationResiduals(fit, goal_functions_.functions, backward_solutions_);
}

Eigen::MatrixXd DensityErrorEstimator::backward_solution_coefficients(
    Eigen::Index goal_function) const {
  return backward_solutions_.spline_coefficients.col(goal_function)
      .reshaped<Eigen::RowMajor>(y_splines().size(), v_splines().size());
}

DensityErrorEstimates DensityErrorEstimator::estimate_errors(
    const transform::Density& density) const {
  const DensityIntegrals integrals = weak_residual_integrator_.integrate_density(density);
  DensityErrorEstimates result{.mass = integrals.mass,
                               .corrected_moments = integrals.moments,
                               .moment_errors = {},
                               .moment_error_contributions = {},
                               .unresolved_residuals = {},
                               .residual_differences_between_wells = {},
                               .y_l1 = {},
                               .ydot_l1 = {}};
  const Eigen::VectorXd errors = -(backward_solutions_.spline_coefficients.transpose() *
                                   integrals.weak_residuals.reshaped<Eigen::RowMajor>().eval());
  const Eigen::VectorXd unresolved =
      unresolved_residual_.mean_absolute_backward_residuals(integrals);
  const Eigen::VectorXd& residual_differences_between_wells =
      unresolved_residual_.residual_differences_between_wells();
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    const Eigen::MatrixXd h = backward_solution_coefficients(static_cast<Eigen::Index>(k));
    const double mean = h.cwiseProduct(integrals.spline_means).sum();
    result.moment_error_contributions[k] =
        -((h.array() - mean) * integrals.weak_residuals.array()).matrix();
    const auto moment = transform::kMoments[k].moment;
    result.moment_errors.*moment = result.moment_error_contributions[k].sum();
    result.corrected_moments.*moment -= result.moment_errors.*moment;
    result.unresolved_residuals[k] = unresolved(static_cast<Eigen::Index>(k));
    result.residual_differences_between_wells[k] =
        residual_differences_between_wells(static_cast<Eigen::Index>(k));
  }
  const auto components_of_bins = [&](int first, int count) {
    return L1ErrorComponents{errors.segment(first, count).cwiseAbs().sum(),
                             unresolved.segment(first, count).sum(),
                             residual_differences_between_wells.segment(first, count).sum() / 2};
  };
  result.y_l1 = components_of_bins(goal_functions_.moment_count, goal_functions_.y_bin_count);
  result.ydot_l1 = components_of_bins(goal_functions_.moment_count + goal_functions_.y_bin_count,
                                      goal_functions_.v_bin_count);
  return result;
}

Eigen::MatrixXd DensityErrorEstimator::distribute_contributions_over_cells(
    const Eigen::MatrixXd& contributions, std::span<const double> y_edges,
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
      spline_integral_fractions_in_cells(y_splines(), y_edges) * contributions *
      spline_integral_fractions_in_cells(v_splines(), v_edges).transpose();
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

Eigen::MatrixXd spline_integral_fractions_in_cells(const numerics::QuinticBSplines& splines,
                                                   std::span<const double> edges) {
  if (edges.size() < 2 ||
      std::ranges::adjacent_find(edges, std::greater_equal<>()) != edges.end()) {
    throw InputError("the cell edges of a map do not increase");
  }
  // Three Gauss points integrate the splines exactly, since the splines are polynomials of degree 5
  // between breaks and edges.
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
  // The integral of a B-spline of degree n is the width of its support divided by n + 1 (de Boor).
  for (int i = 0; i < splines.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& knots = splines.knots();
    fractions.col(i) *= (numerics::QuinticBSplines::kDegree + 1) /
                        (knots[k + numerics::QuinticBSplines::kDegree + 1] - knots[k]);
  }
  return fractions;
}

}  // namespace fpkcheck::backward
