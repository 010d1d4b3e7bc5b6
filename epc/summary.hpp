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

/// The set on which C exp(Q_n) is used as a density, and what Q_n does at infinity.
struct SupportSummary {
  double least_radius;     ///< of its edge, in deviations of the weights (25)-(26)
  double greatest_radius;  ///< likewise
  double y_max, v_max;     ///< ends of the box around it
  double edge_density;     ///< largest density on the edge, relative to the peak
  double cut_off;          ///< estimated probability outside; see gaussian::Support::cut_off
  double y_min = 0;        ///< where the box begins in y
};

/// A point of the branch of solutions that starts from the exact density of white noise at an
/// impact without loss, and on which 1-r, E[Y], E[Y^3], E[Y^4] and, for `kf`, the rest of the jump
/// integral grow with the fraction. The full problem is at fraction 1.
struct BranchPoint {
  double fraction;
  double norm;                     ///< of the coefficients in the scaled basis
  double smallest_singular_value;  ///< of the Jacobian there; zero at a fold
  int determinant_sign;            ///< of the Jacobian; changes at a fold
  bool falls;                      ///< Q_n falls in every direction, paper (19)
  bool fold;                       ///< the fraction turns round here
};

/// How the branch was left.
enum class BranchEnd {
  not_followed,  ///< a root had been found otherwise
  full_problem,  ///< it reaches fraction 1
  white_noise,   ///< it comes back to fraction 0, at another root of the equations of white noise
  far_away,      ///< the coefficients grow beyond all measure
  lost           ///< the steps shrank to nothing, or the allowed points were spent
};
inline constexpr base::Named<BranchEnd> kBranchEndNames[] = {
    {BranchEnd::not_followed, "not_followed"},
    {BranchEnd::full_problem, "full_problem"},
    {BranchEnd::white_noise, "white_noise"},
    {BranchEnd::far_away, "far_away"},
    {BranchEnd::lost, "lost"}};
constexpr std::span<const base::Named<BranchEnd>> names(BranchEnd) { return kBranchEndNames; }
constexpr std::string_view name(BranchEnd end) { return base::name_of(end); }

struct Branch {
  BranchEnd end = BranchEnd::not_followed;
  double furthest = 0;              ///< greatest fraction
  std::vector<BranchPoint> points;  ///< in the order of its length
};

/// What the formulations on the half-plane, moment and polar, report of their own.
struct HalfPlaneSummary {
  Tail tail;
  double level;              ///< energy of the confinement or the cut
  double level_deviations;   ///< sqrt(2 level / E[v^2])
  double beyond_level;       ///< estimated probability there, half_plane::probability_beyond
  double quadrature_change;  ///< by how much more points would change Q_n: half_plane::Root
  int homotopies;            ///< how often damped Newton steps alone were lost
};

/// What the solver reports besides the solution itself. Support and leading form are absent, and
/// there are no coefficients, when no root was found.
struct Summary {
  int order = 0;
  Formulation formulation = Formulation::gaussian;
  int iterations = 0;   ///< Newton steps, all attempts together
  double residual = 0;  ///< largest projection (23) relative to c, at the best iterate
  /// Of Newton's matrix at the root: gaussian: in the scaled unknowns of gaussian::Basis; moment,
  /// polar: half_plane::condition_of.
  std::optional<double> condition = {};
  /// Of Q_n in physical monomials (polar: of rho and theta), constant left out.
  std::vector<Term> coefficients = {};
  std::optional<Frame> frame = {};  ///< with them, all that evaluates the density again
  std::optional<SupportSummary> support = {};
  std::optional<LeadingForm> leading_form = {};  ///< of Q_n
  /// How far the marginals are from those of the root of order n-2: the sum of the L1 distances of
  /// p(y) and p(y'). Where the orders converge fast, about the error at n-2. Absent for n = 2 and
  /// when there is no such root.
  std::optional<double> distance_to_previous = {};
  transform::Moments moments = {};  ///< of the density in the coordinates of Q_n
  /// Of the density, where there is one; an approximate density misses them by its own error.
  transform::BalanceResiduals balances = {};
  /// Of gaussian with `kf`: relative change of the scaled coefficients when the disc of
  /// gaussian::JumpRemainder is a deviation smaller.
  std::optional<double> disc_sensitivity = {};
  Branch branch = {};  ///< of gaussian: followed where Newton's method alone finds no root
  /// Of gaussian: whether plain Newton steps from equivalent linearisation, as in the paper, do.
  bool plain_newton_converges = false;
  std::optional<HalfPlaneSummary> half_plane = {};
};

/// What a closure comes to.
struct Result {
  transform::Solution solution;
  Summary summary;
};

/// The summary as observations, in the order in which files show them.
/// @param moments in the coordinates of Q_n: a coefficient is known to what it does to the density
transform::Observations observations(const Summary& summary, const transform::Moments& moments);

}  // namespace fpkcheck::epc
