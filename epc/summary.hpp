#pragma once

#include <optional>
#include <vector>

#include "epc/form/closed_form.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/options.hpp"
#include "transform/metric.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::epc {

/// Size of the support, which is the set on which C exp(Q_n) is used as a density.
struct SupportSummary {
  /// smallest radius of the edge, in standard deviations of the weights (25)-(26)
  double least_radius;
  double greatest_radius;  ///< largest radius of the edge, in the same unit
  double y_max, v_max;     ///< upper ends of the bounding box in y and v
  double edge_density;     ///< largest density on the edge, relative to the peak of the density
  /// estimated probability outside the support; see gaussian::DensitySupport::cut_off_probability
  double cut_off;
  double y_min = 0;  ///< lower end of the bounding box in y
};

/// A point of the branch of solutions that starts from the exact density under white noise with
/// elastic impacts. On this branch the quantities 1-r, E[Y], E[Y^3], E[Y^4] and, for `kf`, the
/// remainder of the jump integral are multiplied by `fraction`. The full problem has fraction 1.
struct SolutionBranchPoint {
  double fraction;
  double norm;                     ///< norm of the coefficients in the scaled basis
  double smallest_singular_value;  ///< smallest singular value of the Jacobian; zero at a fold
  int determinant_sign;            ///< sign of the Jacobian's determinant; changes at a fold
  bool falls;                      ///< whether Q_n falls in every direction, paper (19)
  bool fold;                       ///< whether the fraction has an extremum at this point
};

/// Reason why the path along a branch of solutions ended.
enum class SolutionBranchEnd {
  not_followed,  ///< another attempt had found a root, and the branch was not computed
  full_problem,  ///< the branch reaches fraction 1
  white_noise,   ///< the branch returns to fraction 0, at another root of the white-noise equations
  far_away,      ///< the norm of the coefficients exceeds the limit of the path: divergence
  lost           ///< the steps became too short, or the largest number of points was reached
};
inline constexpr base::EnumEntry<SolutionBranchEnd> kSolutionBranchEndNames[] = {
    {SolutionBranchEnd::not_followed, "not_followed"},
    {SolutionBranchEnd::full_problem, "full_problem"},
    {SolutionBranchEnd::white_noise, "white_noise"},
    {SolutionBranchEnd::far_away, "far_away"},
    {SolutionBranchEnd::lost, "lost"}};
constexpr const auto& enumerator_names(SolutionBranchEnd) { return kSolutionBranchEndNames; }
constexpr std::string_view name(SolutionBranchEnd end) { return base::name_of(end); }

struct SolutionBranch {
  SolutionBranchEnd end = SolutionBranchEnd::not_followed;
  double furthest = 0;                      ///< largest fraction on the branch
  std::vector<SolutionBranchPoint> points;  ///< points in the order of the arclength
};

/// Part of the summary that only the formulations on the half-plane, moment and polar, have.
struct HalfPlaneSummary {
  TailTreatment tail;       ///< treatment of the density beyond the confinement level
  double level;             ///< confinement level, or energy beyond which the density is cut to 0
  double level_deviations;  ///< confinement level in deviations of v: sqrt(2 level / E[v^2])
  /// estimated probability beyond the confinement level, by half_plane::probability_beyond_contour
  double beyond_level;
  double
      quadrature_change;  ///< change of Q_n on more quadrature points: half_plane::RootSearchResult
  int homotopies;         ///< number of homotopies followed after damped Newton steps failed
};

/// Quantities that the solver of the closure reports besides the solution. If no root was found,
/// support and leading form are absent and the list of coefficients is empty.
struct Summary {
  int order = 0;  ///< order n of the closure
  Formulation formulation = Formulation::gaussian;
  int iterations = 0;   ///< number of Newton steps of all attempts together
  double residual = 0;  ///< largest projection (23) relative to c, at the best iterate
  /// Condition number of the Jacobian at the root. In the formulation gaussian, the unknowns are
  /// the scaled unknowns of gaussian::Basis. In the formulations moment and polar, the number is
  /// half_plane::condition_number.
  std::optional<double> condition = {};
  /// Coefficients of Q_n in unscaled monomials, without the constant term. The formulation polar
  /// has monomials of rho and theta.
  std::vector<Term> coefficients = {};
  /// parameters that define the density together with the coefficients
  std::optional<ClosedFormParameters> frame = {};
  std::optional<SupportSummary> support = {};
  std::optional<LeadingForm> leading_form = {};  ///< behaviour of Q_n at infinity
  /// Distance between the densities of order n and n-2: sum of the L1 distances of p(y) and p(y').
  /// If the sequence of orders converges fast, this distance is about the error at order n-2. The
  /// distance is absent for n = 2, and if no root of order n-2 was found.
  std::optional<double> distance_to_previous = {};
  transform::Moments moments = {};  ///< moments of the density in the coordinates of Q_n
  /// Residuals of the virial and the momentum balance of the density; empty if there is no density.
  /// The residuals of an approximate density have the size of its error.
  transform::BalanceResiduals balances = {};
  /// Relative change of the scaled coefficients if the radius of the disc of
  /// gaussian::JumpIntegralRemainder is smaller by one standard deviation. Only the formulation
  /// gaussian with `kf` sets this value.
  std::optional<double> disc_sensitivity = {};
  /// branch of solutions, which the formulation gaussian follows if Newton's method finds no root
  SolutionBranch branch = {};
  /// In the formulation gaussian: whether plain Newton steps from equivalent linearisation, as in
  /// the paper, converge.
  bool plain_newton_converges = false;
  std::optional<HalfPlaneSummary> half_plane = {};
};

/// Result of a solution by the closure.
struct Result {
  transform::Solution solution;
  Summary summary;
};

/// Metrics that contain the summary, in the order in which files list the metrics.
/// @param moments moments in the coordinates of Q_n, which scale the effect of a coefficient on the
///        density
transform::Metrics metrics(const Summary& summary, const transform::Moments& moments);

// Limits within which the density of a root is accepted. docs/closure.md has the experiments that
// set the limits.

/// Largest accepted density on the edge of the support, relative to the peak of the density.
inline constexpr double kEdgeDensityLimit = 1e-6;

/// Largest accepted difference between the integral of the density and 1. A smaller difference is
/// attributed to quadrature error.
inline constexpr double kMassTolerance = 1e-4;

/// Largest accepted residual of the energy balance, relative to the input power, for a root of the
/// formulation gaussian. The energy balance is the equation projected on x2^2 without the weights.
/// A root of order n = 2 satisfies the balance exactly, and roots of higher order approximately.
/// The largest residual of a good root was 0.08. At the residual 0.16 (r = 0.85, n = 6) E[y^2] has
/// an error of 20 %. Roots far from any stationary density have residuals of 0.4 and more, although
/// Q_n falls in every direction.
inline constexpr double kEnergyResidualLimit = 0.1;

/// Largest accepted Summary::distance_to_previous of a root. The limit applies only if the density
/// of order n-2 is admissible. The distance of good roots is below 0.16 at n = 4, where the density
/// of order n-2 is a Gaussian, and below 0.04 from n = 6 on.
inline constexpr double kOrderDistanceLimit = 0.3;

}  // namespace fpkcheck::epc
