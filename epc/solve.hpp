#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "epc/basis.hpp"
#include "epc/branch.hpp"
#include "epc/moment/confinement.hpp"
#include "epc/polynomial.hpp"
#include "epc/residual.hpp"
#include "epc/support.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

/// Exponential-polynomial closure: a density C exp(Q_n) whose coefficients meet weak moment
/// equations.
namespace fpkcheck::epc {

enum class Formulation {
  gaussian,  ///< the paper's (17)-(26): projections under Gaussian weights in the (z, z') plane
  moment,    ///< exact moment equations on the half-plane y >= 0, see epc/moment/
  polar      ///< the same with Q_n in amplitude and phase, see epc/polar/
};

/// The formulation's name in options, ids and summaries: "gaussian", "moment", "polar".
std::string_view name(Formulation formulation);

/// The equation's name in summaries: "white", "km4", "kf".
std::string_view name(Equation equation);

/// Double precision carries the equations up to these orders; beyond them rounding shows.
int greatest_order(Formulation formulation);

struct Options {
  int order = 6;  ///< n of paper (18): even, 2 .. greatest_order
  Formulation formulation = Formulation::gaussian;
  MonomialSet monomials = MonomialSet::point_symmetric;  ///< of the formulation gaussian
  Equation equation = Equation::km4;                     ///< moment: kf or white; polar: kf
  moment::Tail tail = moment::Tail::confined;            ///< of the formulation moment
  /// On the largest projection (23), relative to residual_unit; moment, polar: on moment::size_of.
  double tolerance = 1e-10;
  /// Of Newton's method: gaussian: plain steps from equivalent linearisation; moment: at each
  /// order.
  int max_iterations = 30;
};

/// @throws InputError naming the option, its value and what is allowed
void validate(const Options& options);

/// The solution's id, such as epc-gaussian-n6, epc-gaussian-white-n4, epc-moment-n8,
/// epc-polar-n6: the equation
/// is named where it is not the formulation's usual one (gaussian: km4; moment: kf).
std::string id(const Options& options);

/// The set on which C exp(Q_n) is used as a density, and what Q_n does at infinity.
struct SupportSummary {
  double least_radius;     ///< of its edge, in deviations of the weights (25)-(26)
  double greatest_radius;  ///< likewise
  double y_max, v_max;     ///< half-widths of the box around it
  double edge_density;     ///< largest density on the edge, relative to the peak
  double cut_off;          ///< estimated probability outside; see Support::cut_off
};

/// What the formulations moment and polar report of their own.
struct MomentSummary {
  moment::Tail tail;
  double level;              ///< energy of the confinement or the cut
  double level_deviations;   ///< sqrt(2 level / E[v^2])
  double beyond_level;       ///< estimated probability there, moment::probability_beyond
  double quadrature_change;  ///< by how much more points would change Q_n: moment::Root
  int homotopies;            ///< how often damped Newton steps alone were lost
};

/// What the solver reports besides the solution itself. Support and leading form are absent, and
/// there are no coefficients, when no root was found.
struct Summary {
  int order = 0;
  Formulation formulation = Formulation::gaussian;
  int iterations = 0;   ///< Newton steps, all attempts together
  double residual = 0;  ///< largest projection (23) relative to c, at the best iterate
  /// Of Newton's matrix at the root: gaussian: in the scaled unknowns of Basis; moment:
  /// moment::condition_of.
  std::optional<double> condition;
  std::vector<Term> coefficients;  ///< of Q_n in physical monomials, constant left out
  std::optional<SupportSummary> support;
  std::optional<LeadingForm> leading_form;  ///< of Q_n
  /// How far the marginals are from those of the root of order n-2: the sum of the L1 distances of
  /// p(y) and p(y'). Where the orders converge fast, about the error at n-2. Absent for n = 2 and
  /// when there is no such root.
  std::optional<double> distance_to_previous;
  /// Of gaussian with `kf`: relative change of the scaled coefficients when the disc of
  /// JumpRemainder is a deviation smaller.
  std::optional<double> disc_sensitivity;
  Branch branch;  ///< of gaussian: followed where Newton's method alone finds no root
  std::optional<MomentSummary> moment;
};

struct Result {
  transform::Solution solution;
  Summary summary;
};

/// Solves (23) by find_root and judges the root. The status is
///  - ok: the density is below Support::kEdgeAllowed of its peak on the whole edge, its mass is
///    within kMassAllowed of 1, the stationary energy balance is met within kEnergyAllowed, and the
///    root is within kDistanceAllowed of that of order n-2 where the latter is a density;
///  - inadmissible: a root, but not such a density. Density and coefficients are still returned;
///  - not_converged: no root was found, or for `kf` none that stands on a plateau of the disc of
///    JumpRemainder; no density.
/// @throws InputError from validate
Result solve(const problem::Problem& problem, const Options& options);

/// Largest residual of the energy balance, relative to the input, of a root that passes for a
/// solution. The balance is the equation projected on x2^2 without the weights, so that n = 2 meets
/// it exactly and higher orders nearly do: 0.08 is the most of any good root met. At 0.16
/// (r = 0.85, n = 6) E[y^2] is 20 % wrong, and roots that Newton's method finds far from any
/// stationary density miss it by 0.4 and more, with Q_n falling properly all the same.
inline constexpr double kEnergyAllowed = 0.1;

/// Largest difference of the density's mass from 1 that passes for quadrature error.
inline constexpr double kMassAllowed = 1e-4;

/// Largest Summary::distance_to_previous of a root that passes for a solution, where the root of
/// order n-2 is itself a density. Good roots stay below 0.16 at n = 4, whose predecessor is a mere
/// Gaussian, and below 0.04 from n = 6 on.
inline constexpr double kDistanceAllowed = 0.3;

/// The same for `moment` and `polar` from n = 6 on: whatever was further from a simulation than 0.2
/// was further than this from order n-2.
inline constexpr double kSettledDistance = 0.2;

/// The fields of summary.json that belong to this solver.
nlohmann::ordered_json to_json(const Summary& summary);

/// The options as asked for.
nlohmann::ordered_json to_json(const Options& options);

/// The options that to_json wrote.
/// @throws InputError naming the field that is missing, unknown or of the wrong type
Options options_from_json(const nlohmann::ordered_json& json);

}  // namespace fpkcheck::epc
