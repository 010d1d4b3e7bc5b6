#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/options/option_description.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "transform/solution_identity.hpp"

/// Exponential-polynomial closure: a density C exp(Q_n) with a polynomial Q_n, whose coefficients
/// satisfy weak moment equations.
namespace fpkcheck::epc {

using problem::DensityEquation;
using problem::ImpactCondition;

/// Formulation of the closure: variables of the polynomial Q_n in the exponent, and equations for
/// the coefficients of Q_n.
enum class Formulation {
  /// Equations (17)-(26) of the paper: projections with Gaussian weights in the (z, z') plane
  gaussian,
  moment,  ///< exact moment equations, Q_n a polynomial of y and v
  /// Exact moment equations, with a polynomial Q_n of amplitude and phase in the exponent. If the
  /// mass can rest in contact with a wall, Q_n is a polynomial of amplitude and velocity.
  polar
};
inline constexpr base::EnumEntry<Formulation> kFormulationNames[] = {
    {Formulation::gaussian, "gaussian", "the paper's projections under Gaussian weights"},
    {Formulation::moment, "moment", "exact moment equations on the half-plane"},
    {Formulation::polar, "polar", "exact moment equations in amplitude and phase, or velocity"}};
constexpr const auto& enumerator_names(Formulation) { return kFormulationNames; }
constexpr std::string_view name(Formulation formulation) { return base::name_of(formulation); }

/// Monomials x1^p x2^q of the polynomial Q_n, and of the projections of the formulation `gaussian`.
enum class MonomialSet {
  point_symmetric,  ///< p + q = 2, 4, .. n: monomials that are even under (x1, x2) -> (-x1, -x2)
  general           ///< p + q = 1, 2, .. n: all monomials of paper (18)
};
inline constexpr base::EnumEntry<MonomialSet> kMonomialSetNames[] = {
    {MonomialSet::point_symmetric, "point_symmetric"}, {MonomialSet::general, "general"}};
constexpr const auto& enumerator_names(MonomialSet) { return kMonomialSetNames; }
constexpr std::string_view name(MonomialSet set) { return base::name_of(set); }

/// Treatment of the closure density above the confinement level, the energy up to which the
/// exponent Q_n is reliable.
enum class DensityTailTreatment {
  confined,  ///< the exponent Q_n + Confinement gives a density on the whole half-plane
  cut        ///< the density C exp(Q_n) is cut to 0 beyond the confinement level
};
inline constexpr base::EnumEntry<DensityTailTreatment> kTailTreatmentNames[] = {
    {DensityTailTreatment::confined, "confined"}, {DensityTailTreatment::cut, "cut"}};
constexpr const auto& enumerator_names(DensityTailTreatment) { return kTailTreatmentNames; }
constexpr std::string_view name(DensityTailTreatment tail) { return base::name_of(tail); }

struct ClosureOptions {
  int order = 6;  ///< order n of paper (18): even, 2 .. max_closure_order
  Formulation formulation = Formulation::gaussian;
  MonomialSet monomials = MonomialSet::point_symmetric;
  std::optional<DensityEquation> equation = {};  ///< equation to solve; default_equation() if empty
  DensityTailTreatment tail = DensityTailTreatment::confined;
  /// Tolerance on the norm of the residual. In the formulation `gaussian`, the norm of the residual
  /// is the largest projection (23) of the paper in units of gaussian::unit_of_projected_residual.
  /// In the formulations `moment` and `polar`, the norm of the residual is
  /// half_plane::residual_norm.
  double tolerance = 1e-10;
  /// Largest L1 error of the marginal densities p(y) and p(y') of a closure with the status `ok`.
  /// The closure solver does not compute the L1 error of its density; the caller estimates this
  /// error. If no accuracy is requested, the caller does not estimate the L1 error.
  std::optional<double> accuracy = 2e-2;
  /// Largest number of Newton steps from one starting point of the search for a closure root.
  int max_iterations = 30;
  /// Time limit in seconds of the root search in the formulations `moment` and `polar`. After the
  /// time limit the search for a root of the closure equations begins no further attempt.
  double max_seconds = 20;
};

const base::OptionsDescription<ClosureOptions>& solver_option_descriptions();

/// @throws InputError whose message states the invalid option, its value and the allowed values
void validate(const ClosureOptions& options);

/// Largest order n of the polynomial Q_n for which double precision suffices. Rounding errors
/// dominate the results of closures of orders above max_closure_order().
int max_closure_order(Formulation formulation);

DensityEquation default_equation(Formulation formulation);

/// Returns the density equation of the options, or else the default of the formulation.
DensityEquation closure_density_equation(const ClosureOptions& options);

/// Returns the id of the closure solution, such as epc-gaussian-n6 or epc-moment-cut-n8. The id of
/// a closure contains the name of the density equation only if this equation is not the default
/// equation of the formulation.
std::string solution_id(const ClosureOptions& options);

/// Parses the closure options from the id of a solution, without checking the ranges of the
/// options. For the id of a solution that is no closure the result is empty.
std::optional<ClosureOptions> options_of(std::string_view id);

/// Returns the identity of the closure solution, whose field `formulation` is the part of the id
/// between "epc-" and "-nN".
transform::SolutionIdentity solution_identity(const ClosureOptions& options);

}  // namespace fpkcheck::epc
