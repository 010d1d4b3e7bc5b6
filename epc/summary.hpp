#pragma once

#include <optional>
#include <vector>

#include "epc/form/closed_form_parameters.hpp"
#include "epc/form/exponent_polynomial.hpp"
#include "epc/options.hpp"
#include "problem/problem.hpp"
#include "transform/marginal_density.hpp"
#include "transform/solution.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::epc {

/// Size of the support of the closure density, the set on which the density C exp(Q_n) is not 0.
struct DensitySupportSummary {
  /// Smallest radius of the edge of the support, in standard deviations of the Gaussian weights
  /// (25)-(26) of the paper
  double least_radius;
  /// Largest radius of the edge of the support, in standard deviations of the Gaussian weights
  /// (25)-(26) of the paper
  double greatest_radius;
  double y_max, v_max;
  double edge_density;  ///< largest density on the edge, relative to the peak density
  /// Estimated probability outside the support of the closure density, by
  /// gaussian::DensitySupport::probability_outside_support
  double cut_off;
  double y_min = 0;
};

/// Point on the branch of solutions from the exact density under white noise with elastic impacts
/// to the full problem. On the branch, 1-r, E[Y], E[Y^3], E[Y^4] and, for the equation `kf`, the
/// remainder of the jump integral are multiplied by `fraction`. The full problem has fraction 1.
struct SolutionBranchPoint {
  double fraction;
  double norm;
  double smallest_singular_value;  ///< smallest singular value of the Jacobian, 0 at a fold
  int determinant_sign;            ///< sign of the Jacobian's determinant, changes at a fold
  bool falls;  ///< whether the exponent Q_n falls to minus infinity in every direction, paper (19)
  bool fold;   ///< whether the fraction has a maximum or minimum at this point
};

/// Reason why the continuation along a branch of solutions ended.
enum class SolutionBranchEndReason {
  not_followed,  ///< branch not computed, since another attempt had found a root
  full_problem,
  white_noise,  ///< return to fraction 0, at another root of the white-noise equations
  far_away,     ///< divergence: the norm of the coefficients exceeds the limit of the continuation
  lost          ///< continuation stopped by too short steps or by the largest number of points
};
inline constexpr base::EnumEntry<SolutionBranchEndReason> kSolutionBranchEndNames[] = {
    {SolutionBranchEndReason::not_followed, "not_followed"},
    {SolutionBranchEndReason::full_problem, "full_problem"},
    {SolutionBranchEndReason::white_noise, "white_noise"},
    {SolutionBranchEndReason::far_away, "far_away"},
    {SolutionBranchEndReason::lost, "lost"}};
constexpr const auto& enumerator_names(SolutionBranchEndReason) { return kSolutionBranchEndNames; }
constexpr std::string_view name(SolutionBranchEndReason end) { return base::name_of(end); }

struct SolutionBranch {
  SolutionBranchEndReason end = SolutionBranchEndReason::not_followed;
  double furthest = 0;
  std::vector<SolutionBranchPoint> points;
};

/// Summary of a closure in the formulations on the half-plane y >= 0, `moment` and `polar`.
struct HalfPlaneClosureSummary {
  DensityTailTreatment tail;
  double level;             ///< confinement level, or energy beyond which the density is cut to 0
  double level_deviations;  ///< confinement level in deviations of v: sqrt(2 level / E[v^2])
  /// Estimated probability above the confinement level (an energy), by
  /// half_plane::probability_beyond_contour
  double beyond_level;
  /// Standard deviation of the change of the exponent Q_n when quadrature points are added
  double quadrature_change;
  int homotopies;
  /// Decay rate and frequency of the slowest deviation of the moments from the root of the closure
  /// equations, under the linearised moment equations
  double relaxation_rate, relaxation_frequency;
};

/// Quantities that the closure solver returns in addition to the density and its moments. If no
/// root of the closure equations was found, support, leading form and coefficients are absent.
struct ClosureSummary {
  int order = 0;
  Formulation formulation = Formulation::gaussian;
  int iterations = 0;
  // largest projection (23), or largest rate of change of a moment, relative to the damping c
  double residual = 0;
  /// Condition number of the Jacobian at the root, in the scaled unknowns of
  /// gaussian::GaussianWeightedBasis (`gaussian`) or by half_plane::condition_number (`moment`,
  /// `polar`).
  std::optional<double> condition = {};
  /// Coefficients of the polynomial Q_n in unscaled monomials, without the constant term.
  std::vector<ExponentMonomial> coefficients = {};
  std::optional<ClosedFormDensityParameters> frame = {};
  std::optional<DensitySupportSummary> support = {};
  std::optional<ExponentBehaviourAtInfinity> leading_form =
      {};  ///< behaviour of the exponent Q_n at infinity
  /// Distance between the closure densities of order n and n-2: sum of the L1 distances of p(y) and
  /// p(y'). If the closure densities converge fast with increasing order, the distance between
  /// orders n and n-2 approximates the error of closure order n-2. If the closure equations of
  /// order n-2 have no root, the distance between the orders n and n-2 is empty.
  std::optional<double> distance_to_previous = {};
  transform::Moments moments = {};
  /// Residuals of the virial balance and of the momentum balance of the closure density.
  transform::BalanceResiduals balances = {};
  /// Relative change of the coefficients of Q_n when the disc of gaussian::JumpIntegralRemainder is
  /// reduced in radius by one standard deviation (equation `kf`).
  std::optional<double> disc_sensitivity = {};
  /// Branch of solutions, which the formulation `gaussian` follows if Newton's method finds no root
  SolutionBranch branch = {};
  /// Whether undamped Newton steps from equivalent linearisation (the paper's method) converge.
  bool plain_newton_converges = false;
  std::optional<HalfPlaneClosureSummary> half_plane = {};
};

struct ClosureResult {
  transform::Solution solution;
  ClosureSummary summary;
};

/// Stores a density in the solution (transform::store_smooth_density()), and its moments and
/// balance residuals in the summary, in the coordinates of the problem's frame.
/// @param impact impact condition of the equation, which defines the power lost in impacts
/// @return marginal densities
transform::QuadratureMarginals store_density(
    const problem::Problem& problem, problem::ImpactCondition impact,
    const transform::SmoothDensity& density, ClosureResult& result,
    transform::QuadraturePanelSpacing panels = transform::QuadraturePanelSpacing::uniform);

/// Returns the metrics of a closure summary, in the order of the output files.
/// @param moments moments in the variables of the polynomial Q_n, which scale the effect of a
/// coefficient of Q_n on the density
transform::Metrics solver_metrics(const ClosureSummary& summary, const transform::Moments& moments);

// Each root of the closure equations determines a density, which may be inadmissible. The following
// limits decide whether the density of a root of the closure equations is accepted. The page
// docs/closure.md has the experiments that set the limits.

/// Largest density on the edge of the support of an accepted closure, relative to the peak density.
inline constexpr double kMaxSupportEdgeDensity = 1e-6;

/// Largest difference between the integral of the closure density and 1 due to the quadrature.
inline constexpr double kClosureMassTolerance = 1e-4;

/// Largest residual of the energy balance of an accepted closure, relative to the input power, in
/// the formulation `gaussian`. A closure of order n = 2 satisfies the energy balance exactly, a
/// closure of higher order approximately. The energy balance is the density equation projected on
/// the monomial x2^2 without a weight function. The largest residual of the energy balance of an
/// accurate closure was 0.08 of the input power. At a residual of the energy balance of 0.16
/// (restitution coefficient r = 0.85, order n = 6), E[y^2] has an error of 20 %. Roots far from any
/// stationary density have residuals of the energy balance of at least 0.4 of the input power.
inline constexpr double kMaxClosureEnergyResidual = 0.1;

/// Largest L1 distance of an accepted closure density of order n from the density of order n-2, if
/// the density of order n-2 is admissible. Accurate closures have L1 distances from the closure of
/// order n-2 below 0.16 at n = 4, where the closure of order n-2 is a Gaussian density, and below
/// 0.04 from n = 6 on.
inline constexpr double kMaxL1DistanceToPreviousOrder = 0.3;

}  // namespace fpkcheck::epc
