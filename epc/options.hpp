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

/// Formulation of the closure: coordinates of the polynomial Q_n, and equations for its
/// coefficients.
enum class Formulation {
  /// Equations (17)-(26) of the paper: projections under Gaussian weights in the (z, z') plane
  gaussian,
  moment,  ///< exact moment equations, Q_n a polynomial of y and v
  /// Exact moment equations, Q_n a polynomial of amplitude and phase. If the mass can rest in
  /// contact with a wall, Q_n is a polynomial of amplitude and velocity (epc/contact/).
  polar
};
inline constexpr base::EnumEntry<Formulation> kFormulationNames[] = {
    {Formulation::gaussian, "gaussian", "the paper's projections under Gaussian weights"},
    {Formulation::moment, "moment", "exact moment equations on the half-plane"},
    {Formulation::polar, "polar", "exact moment equations in amplitude and phase, or velocity"}};
constexpr const auto& enumerator_names(Formulation) { return kFormulationNames; }
constexpr std::string_view name(Formulation formulation) { return base::name_of(formulation); }

/// Monomials x1^p x2^q in the polynomial Q_n and in the projections of the formulation `gaussian`.
enum class MonomialSet {
  point_symmetric,  ///< p + q = 2, 4, .. n: monomials that are even under (x1, x2) -> (-x1, -x2)
  general           ///< p + q = 1, 2, .. n: all monomials of paper (18)
};
inline constexpr base::EnumEntry<MonomialSet> kMonomialSetNames[] = {
    {MonomialSet::point_symmetric, "point_symmetric"}, {MonomialSet::general, "general"}};
constexpr const auto& enumerator_names(MonomialSet) { return kMonomialSetNames; }
constexpr std::string_view name(MonomialSet set) { return base::name_of(set); }

/// Treatment of the density beyond the confinement level, the energy up to which Q_n is reliable.
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
  /// Tolerance on the norm of the residual. In the formulation `gaussian`, this norm is the largest
  /// projection (23) in units of gaussian::unit_of_projected_residual. In the formulations `moment`
  /// and `polar`, this norm is half_plane::residual_norm.
  double tolerance = 1e-10;
  /// Largest L1 error of p(y) and of p(y') with which the caller accepts a solution as `ok`. The
  /// closure solver does not compute the L1 error. Without a requested accuracy the caller does not
  /// estimate the L1 error.
  std::optional<double> accuracy = 2e-2;
  /// Largest number of Newton steps from one starting point of the root search.
  int max_iterations = 30;
  /// Time limit in seconds of the formulations `moment` and `polar`. After this time limit the root
  /// search begins no further attempt.
  double max_seconds = 20;
};

const base::OptionsDescription<ClosureOptions>& solver_option_descriptions();

/// @throws InputError that states the option, its value and the allowed values
void validate(const ClosureOptions& options);

/// Largest closure order n that double precision permits. Rounding errors dominate closures of
/// orders above max_closure_order().
int max_closure_order(Formulation formulation);

DensityEquation default_equation(Formulation formulation);

/// Returns the equation of the options, or the default equation of the formulation.
DensityEquation closure_density_equation(const ClosureOptions& options);

/// Returns the id of the closure solution, such as epc-gaussian-n6 or epc-moment-cut-n8. The id
/// contains the equation only if the equation differs from the default equation.
std::string solution_id(const ClosureOptions& options);

/// Parses the options from the id of a solution, without validation. For the id of another method
/// the result is empty.
std::optional<ClosureOptions> options_of(std::string_view id);

/// Returns the identity of the solution, whose field `formulation` is the part of the id between
/// "epc-" and "-nN".
transform::SolutionIdentity solution_identity(const ClosureOptions& options);

}  // namespace fpkcheck::epc
