#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/options/description.hpp"
#include "problem/model.hpp"
#include "transform/identity.hpp"

/// Exponential-polynomial closure: a density C exp(Q_n) whose coefficients satisfy weak moment
/// equations.
namespace fpkcheck::epc {

using problem::Equation;
using problem::Impact;

/// Formulation of the closure: choice of the unknowns and of the equations.
enum class Formulation {
  /// equations (17)-(26) of the paper: projections under Gaussian weights in the (z, z') plane
  gaussian,
  moment,  ///< exact moment equations on the half-plane y >= 0, see epc/moment/
  /// Exact moment equations, Q_n a polynomial of amplitude and phase, see epc/polar/. If the mass
  /// rests in contact with a wall, Q_n is a polynomial of amplitude and velocity, and the density
  /// is C exp(Q_n) divided by the energy, see epc/contact/.
  polar
};
inline constexpr base::EnumEntry<Formulation> kFormulationNames[] = {
    {Formulation::gaussian, "gaussian", "the paper's projections under Gaussian weights"},
    {Formulation::moment, "moment", "exact moment equations on the half-plane"},
    {Formulation::polar, "polar", "exact moment equations in amplitude and phase, or velocity"}};
constexpr const auto& enumerator_names(Formulation) { return kFormulationNames; }
constexpr std::string_view name(Formulation formulation) { return base::name_of(formulation); }

/// Monomials x1^p x2^q in Q_n and in the projections of the formulation gaussian.
enum class MonomialSet {
  point_symmetric,  ///< p + q = 2, 4, .. n: monomials even under (x1, x2) -> (-x1, -x2)
  general           ///< p + q = 1, 2, .. n, paper (18)
};
inline constexpr base::EnumEntry<MonomialSet> kMonomialSetNames[] = {
    {MonomialSet::point_symmetric, "point_symmetric"}, {MonomialSet::general, "general"}};
constexpr const auto& enumerator_names(MonomialSet) { return kMonomialSetNames; }
constexpr std::string_view name(MonomialSet set) { return base::name_of(set); }

/// Treatment of the density beyond the confinement level, the energy up to which Q_n is reliable.
enum class TailTreatment {
  confined,  ///< the exponent is Q_n + Confinement, which gives a density on the whole half-plane
  cut        ///< the exponent is Q_n alone, and the density is 0 beyond the confinement level
};
inline constexpr base::EnumEntry<TailTreatment> kTailTreatmentNames[] = {
    {TailTreatment::confined, "confined"}, {TailTreatment::cut, "cut"}};
constexpr const auto& enumerator_names(TailTreatment) { return kTailTreatmentNames; }
constexpr std::string_view name(TailTreatment tail) { return base::name_of(tail); }

struct Options {
  int order = 6;  ///< n of paper (18): even, 2 .. max_closure_order
  Formulation formulation = Formulation::gaussian;
  /// monomials of Q_n in the formulation gaussian
  MonomialSet monomials = MonomialSet::point_symmetric;
  std::optional<Equation> equation = {};  ///< equation to solve; empty: default_equation
  TailTreatment tail =
      TailTreatment::confined;  ///< treatment of the tail in the formulation moment
  /// Tolerance on the norm of the residual. In the formulation gaussian, this norm is the largest
  /// projection (23) relative to gaussian::residual_unit. In the formulations moment and polar, the
  /// norm is half_plane::residual_norm.
  double tolerance = 1e-10;
  /// Largest L1 error of p(y) and of p(y') against the full problem with which a solution is ok.
  /// The closure itself has no error estimate: the caller estimates the error. An empty accuracy
  /// (in files of earlier program versions) means that the caller estimates no error.
  std::optional<double> accuracy = 2e-2;
  /// Largest number of Newton steps. The limit applies to the plain steps from equivalent
  /// linearisation in the formulation gaussian, and to the steps at each order in the formulations
  /// moment and polar.
  int max_iterations = 30;
  /// Time limit in seconds of the formulations moment and polar. After this time the search for a
  /// root begins no further attempt.
  double max_seconds = 20;
};

/// Descriptions of all options: the names on the command line and in files, help texts, and ranges
/// of values.
const base::Description<Options>& description();

/// Checks all options.
/// @throws InputError for an invalid option; the message has the option, its value and the allowed
///         values
void validate(const Options& options);

/// Largest order n of the closure in double precision. At higher orders rounding errors dominate.
int max_closure_order(Formulation formulation);

/// Equation that a formulation solves by default: km4 for gaussian, kf for moment and polar.
Equation default_equation(Formulation formulation);

/// Equation that the options select, or the default equation of the formulation.
Equation equation_of(const Options& options);

/// Id of the solution, such as epc-gaussian-n6, epc-gaussian-white-n4, epc-moment-cut-n8. The id
/// contains the equation only if it is not the formulation's default.
std::string id(const Options& options);

/// Options that an id of a solution encodes, without a check by validate(). The result is empty for
/// an id of another method.
std::optional<Options> options_of(std::string_view id);

/// Identity of the solution for given options. The field `formulation` is the part of the id
/// between "epc-" and "-nN".
transform::SolutionIdentity identity(const Options& options);

}  // namespace fpkcheck::epc
