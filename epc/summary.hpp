#pragma once

#include <optional>
#include <vector>

#include "epc/form/closed_form.hpp"
#include "epc/form/leading_form.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/options.hpp"
#include "transform/balance_residuals.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::epc {

/// Support: the set on which C exp(Q_n) is used as a density.
struct SupportSummary {
  double least_radius;     ///< smallest radius of the edge, in deviations of the weights (25)-(26)
  double greatest_radius;  ///< largest radius, likewise
  double y_max, v_max;     ///< upper ends of the bounding box
  double edge_density;     ///< largest density on the edge, relative to the peak
  double cut_off;          ///< estimated probability outside; see gaussian::Support::cut_off
  double y_min = 0;        ///< lower end of the bounding box in y
};

/// A point of the branch of solutions that starts from the exact density under white noise with
/// elastic impacts. On the branch 1-r, E[Y], E[Y^3], E[Y^4] and, for `kf`, the remainder of the
/// jump integral are multiplied by the fraction. The full problem has fraction 1.
struct BranchPoint {
  double fraction;
  double norm;                     ///< norm of the coefficients in the scaled basis
  double smallest_singular_value;  ///< of the Jacobian at the point; zero at a fold
  int determinant_sign;            ///< of the Jacobian; changes at a fold
  bool falls;                      ///< Q_n falls in every direction, paper (19)
  bool fold;                       ///< the fraction has an extremum here
};

/// End of the branch.
enum class BranchEnd {
  not_followed,  ///< another attempt had found a root
  full_problem,  ///< the branch reaches fraction 1
  white_noise,   ///< the branch returns to fraction 0, at another root of the white-noise equations
  far_away,      ///< the coefficients exceed every bound
  lost           ///< the steps became too short, or the largest number of points was reached
};
inline constexpr base::EnumEntry<BranchEnd> kBranchEndNames[] = {
    {BranchEnd::not_followed, "not_followed"},
    {BranchEnd::full_problem, "full_problem"},
    {BranchEnd::white_noise, "white_noise"},
    {BranchEnd::far_away, "far_away"},
    {BranchEnd::lost, "lost"}};
constexpr std::span<const base::EnumEntry<BranchEnd>> names(BranchEnd) { return kBranchEndNames; }
constexpr std::string_view name(BranchEnd end) { return base::name_of(end); }

struct Branch {
  BranchEnd end = BranchEnd::not_followed;
  double furthest = 0;              ///< largest fraction
  std::vector<BranchPoint> points;  ///< ordered by arclength
};

/// Summary that only the formulations on the half-plane, moment and polar, have.
struct HalfPlaneSummary {
  Tail tail;
  double level;              ///< confinement level, or energy of the cut
  double level_deviations;   ///< sqrt(2 level / E[v^2])
  double beyond_level;       ///< estimated probability, half_plane::probability_beyond
  double quadrature_change;  ///< change of Q_n on more quadrature points: half_plane::Root
  int homotopies;            ///< number of homotopies followed after damped Newton steps failed
};

/// Summary of the solver besides the solution itself. Without a root, support and leading form are
/// absent and the coefficients are empty.
struct Summary {
  int order = 0;
  Formulation formulation = Formulation::gaussian;
  int iterations = 0;   ///< Newton steps, all attempts together
  double residual = 0;  ///< largest projection (23) relative to c, at the best iterate
  /// Condition number of the Jacobian at the root. gaussian: in the scaled unknowns of
  /// gaussian::Basis; moment, polar: half_plane::condition_number.
  std::optional<double> condition = {};
  /// Coefficients of Q_n in physical monomials (polar: of rho and theta), without the constant.
  std::vector<Term> coefficients = {};
  std::optional<Frame> frame = {};  ///< defines the density together with the coefficients
  std::optional<SupportSummary> support = {};
  std::optional<LeadingForm> leading_form = {};  ///< of Q_n
  /// Distance of the marginal densities to those of the root of order n-2: sum of the L1 distances
  /// of p(y) and p(y'). If the orders converge fast, about the error at n-2. Absent for n = 2 and
  /// without a root of order n-2.
  std::optional<double> distance_to_previous = {};
  transform::Moments moments = {};  ///< moments of the density in the coordinates of Q_n
  /// Residuals of the balances of the density, empty without a density. The residuals of an
  /// approximate density have the size of its error.
  transform::BalanceResiduals balances = {};
  /// gaussian with `kf`: relative change of the scaled coefficients if the radius of the disc of
  /// gaussian::JumpRemainder is one deviation smaller.
  std::optional<double> disc_sensitivity = {};
  Branch branch = {};  ///< gaussian: followed if Newton's method alone finds no root
  /// gaussian: whether plain Newton steps from equivalent linearisation, as in the paper, converge.
  bool plain_newton_converges = false;
  std::optional<HalfPlaneSummary> half_plane = {};
};

/// Result of a closure.
struct Result {
  transform::Solution solution;
  Summary summary;
};

/// The summary as metrics, in the order of the files.
/// @param moments in the coordinates of Q_n: they scale the effect of a coefficient on the density
transform::Metrics metrics(const Summary& summary, const transform::Moments& moments);

}  // namespace fpkcheck::epc
