#pragma once

#include <optional>
#include <vector>

#include "epc/form/closed_form_parameters.hpp"
#include "epc/form/exponent_polynomial.hpp"
#include "epc/options.hpp"
#include "transform/solution.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::epc {

/// Size of the support of the closure density, the set on which C exp(Q_n) is not 0.
struct DensitySupportSummary {
  /// Smallest radius of the edge of the support, in standard deviations of the weights (25)-(26) of
  /// the paper
  double least_radius;
  /// Largest radius of the edge of the support, in standard deviations of the weights (25)-(26) of
  /// the paper
  double greatest_radius;
  double y_max, v_max;
  double edge_density;  ///< largest density on the edge, relative to the peak density
  /// Estimated probability outside the support, by
  /// gaussian::DensitySupport::probability_outside_support
  double cut_off;
  double y_min = 0;
};

/// Point on the branch of solutions from the exact density under white noise with elastic impacts
/// to the full problem. On the branch, 1-r, E[Y], E[Y^3], E[Y^4] and, for `kf`, the remainder of
/// the jump integral are multiplied by `fraction`. The full problem has fraction 1.
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

/// Summary of the formulations on the half-plane, `moment` and `polar`.
struct HalfPlaneClosureSummary {
  DensityTailTreatment tail;
  double level;             ///< confinement level, or energy beyond which the density is cut to 0
  double level_deviations;  ///< confinement level in deviations of v: sqrt(2 level / E[v^2])
  /// Estimated probability beyond the confinement level, by half_plane::probability_beyond_contour
  double beyond_level;
  /// Standard deviation of the change of the exponent Q_n by additional quadrature points
  double quadrature_change;
  int homotopies;
  /// Decay rate and frequency of the slowest deviation of the moments from the root, under the
  /// linearised moment equations
  double relaxation_rate, relaxation_frequency;
};

/// Quantities that the closure solver reports in addition to the solution. If no root was found,
/// support, leading form and coefficients are absent.
struct ClosureSummary {
  int order = 0;
  Formulation formulation = Formulation::gaussian;
  int iterations = 0;
  // largest projection (23) of the paper, or largest rate of change of a moment, relative to the
  // damping c
  double residual = 0;
  /// Condition number of the Jacobian at the root, in the scaled unknowns of gaussian::Basis
  /// (`gaussian`) or by half_plane::condition_number (`moment`, `polar`).
  std::optional<double> condition = {};
  /// Coefficients of the polynomial Q_n in unscaled monomials, without the constant term.
  std::vector<ExponentMonomial> coefficients = {};
  std::optional<ClosedFormDensityParameters> frame = {};
  std::optional<DensitySupportSummary> support = {};
  std::optional<ExponentBehaviourAtInfinity> leading_form =
      {};  ///< behaviour of the exponent Q_n at infinity
  /// Distance between the densities of closure order n and n-2: sum of the L1 distances of p(y) and
  /// p(y'). If the sequence of orders converges fast, the distance between orders n and n-2
  /// approximates the error of closure order n-2. Without a root of closure order n-2 the distance
  /// is empty.
  std::optional<double> distance_to_previous = {};
  transform::Moments moments = {};
  /// Residuals of the virial balance and of the momentum balance of the closure density.
  transform::BalanceResiduals balances = {};
  /// Relative change of the scaled coefficients if the disc of gaussian::JumpIntegralRemainder is
  /// reduced in radius by one standard deviation (for `kf`).
  std::optional<double> disc_sensitivity = {};
  /// Branch of solutions, which the formulation `gaussian` follows if Newton's method finds no root
  SolutionBranch branch = {};
  /// Whether plain Newton steps from equivalent linearisation, the paper's method, converge.
  bool plain_newton_converges = false;
  std::optional<HalfPlaneClosureSummary> half_plane = {};
};

struct ClosureResult {
  transform::Solution solution;
  ClosureSummary summary;
};

/// Returns the metrics of a summary, in the order in which files list the metrics.
/// @param moments moments in the coordinates of the polynomial Q_n, which scale the effect of a
/// coefficient on the
///   density
transform::Metrics solver_metrics(const ClosureSummary& summary, const transform::Moments& moments);

// A root of the closure equations determines a density. The following limits decide whether this
// density is accepted. docs/closure.md has the experiments that set the limits.

/// Largest accepted density on the edge of the support, relative to the peak density.
inline constexpr double kMaxSupportEdgeDensity = 1e-6;

/// Largest difference between the integral of the density and 1 that counts as quadrature error.
inline constexpr double kClosureMassTolerance = 1e-4;

/// Largest accepted residual of the energy balance, relative to the input power, in the formulation
/// `gaussian`. A root of closure order n = 2 satisfies the energy balance exactly, a root of higher
/// order approximately. The energy balance is the density equation projected on x2^2 without
/// weights. The largest residual of the energy balance of an accurate root was 0.08. At a residual
/// of 0.16 (r = 0.85, n = 6) E[y^2] has an error of 20 %. Roots far from any stationary density
/// have residuals of the energy balance of 0.4 and more.
inline constexpr double kMaxClosureEnergyResidual = 0.1;

/// Largest accepted ClosureSummary::distance_to_previous of a root, if the density of closure order
/// n-2 is admissible. Accurate roots have distances below 0.16 at n = 4, where the density of
/// closure order n-2 is a Gaussian, and below 0.04 from n = 6 on.
inline constexpr double kMaxL1DistanceToPreviousOrder = 0.3;

}  // namespace fpkcheck::epc
