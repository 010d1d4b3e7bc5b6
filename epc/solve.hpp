#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "epc/basis.hpp"
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
  moment     ///< exact moment equations on the half-plane y >= 0, see epc/moment/
};

/// The equation's name in summaries: "white", "km4", "kf".
std::string_view name(Equation equation);

/// Double precision carries the equations up to these orders; beyond them rounding shows.
int greatest_order(Formulation formulation);

struct Options {
  int order = 6;  ///< n of paper (18): even, 2 .. greatest_order
  Formulation formulation = Formulation::gaussian;
  MonomialSet monomials = MonomialSet::point_symmetric;  ///< of the formulation gaussian
  Equation equation = Equation::km4;                     ///< moment: kf or white
  moment::Tail tail = moment::Tail::confined;            ///< of the formulation moment
  /// On the largest projection (23), relative to the damping c; moment: on moment::size_of.
  double tolerance = 1e-10;
  /// Of Newton's method: gaussian: plain steps from equivalent linearisation; moment: at each
  /// order.
  int max_iterations = 30;
};

/// @throws InputError naming the option, its value and what is allowed
void validate(const Options& options);

/// The solution's id, such as epc-gaussian-n6, epc-gaussian-white-n4, epc-moment-n8: the equation
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

/// What the formulation moment reports of its own.
struct MomentSummary {
  moment::Tail tail;
  double level;              ///< energy of the confinement or the cut
  double level_deviations;   ///< sqrt(2 level / E[v^2])
  double beyond_level;       ///< estimated probability there, moment::probability_beyond
  double condition;          ///< of Newton's matrix, moment::condition_of
  double quadrature_change;  ///< by how much twice the points would change Q_n, standard deviation
  int homotopies;            ///< how often damped Newton steps alone were lost
};

/// What the solver reports besides the solution itself. Support and leading form are absent, and
/// there are no coefficients, when no root was found.
struct Summary {
  int order = 0;
  Formulation formulation = Formulation::gaussian;
  int iterations = 0;              ///< Newton steps, all attempts together
  double residual = 0;             ///< largest projection (23) relative to c, at the best iterate
  std::vector<Term> coefficients;  ///< of Q_n in physical monomials, constant left out
  std::optional<SupportSummary> support;
  std::optional<LeadingForm> leading_form;  ///< of Q_n
  std::optional<MomentSummary> moment;
};

struct Result {
  transform::Solution solution;
  Summary summary;
};

/// Solves (23) and judges the root. Newton's plain iteration starts from equivalent linearisation,
/// as in the paper; where that is lost, the branch from the exact density without impact losses is
/// followed. The status is
///  - ok: the density is below Support::kEdgeAllowed of its peak on the whole edge, and the
///  stationary
///    energy balance is met within kEnergyAllowed;
///  - inadmissible: a root, but not such a density. Density and coefficients are still returned;
///  - not_converged: no root was found; no density.
/// @throws InputError from validate
Result solve(const problem::Problem& problem, const Options& options);

/// Largest residual of the energy balance, relative to the input, of a root that passes for a
/// solution. The balance is the equation projected on x2^2 without the weights, so that n = 2 meets
/// it exactly and higher orders nearly do (a few per cent at n = 6); roots that Newton's method
/// finds far from any stationary density miss it by 40 % and more, with Q_n falling properly all
/// the same.
inline constexpr double kEnergyAllowed = 0.2;

/// The fields of summary.json that belong to this solver.
nlohmann::ordered_json to_json(const Summary& summary);

/// The options as asked for.
nlohmann::ordered_json to_json(const Options& options);

}  // namespace fpkcheck::epc
