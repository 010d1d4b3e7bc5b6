#pragma once

#include <optional>
#include <span>
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

/// Choice of unknowns and equations.
enum class Formulation {
  gaussian,  ///< the paper's (17)-(26): projections under Gaussian weights in the (z, z') plane
  moment,    ///< exact moment equations on the half-plane y >= 0, see epc/moment/
  /// Exact moment equations with Q_n in amplitude and phase, see epc/polar/. For a mass at rest in
  /// contact with a wall: amplitude and velocity, density divided by the energy, see epc/contact/.
  polar
};
inline constexpr base::EnumEntry<Formulation> kFormulationNames[] = {
    {Formulation::gaussian, "gaussian", "the paper's projections under Gaussian weights"},
    {Formulation::moment, "moment", "exact moment equations on the half-plane"},
    {Formulation::polar, "polar", "exact moment equations in amplitude and phase, or velocity"}};
constexpr std::span<const base::EnumEntry<Formulation>> names(Formulation) {
  return kFormulationNames;
}
constexpr std::string_view name(Formulation formulation) { return base::name_of(formulation); }

/// Monomials x1^p x2^q in Q_n and in the projections of the formulation gaussian.
enum class MonomialSet {
  point_symmetric,  ///< p + q = 2, 4, .. n: monomials even under (x1, x2) -> (-x1, -x2)
  general           ///< p + q = 1, 2, .. n, paper (18)
};
inline constexpr base::EnumEntry<MonomialSet> kMonomialSetNames[] = {
    {MonomialSet::point_symmetric, "point_symmetric"}, {MonomialSet::general, "general"}};
constexpr std::span<const base::EnumEntry<MonomialSet>> names(MonomialSet) {
  return kMonomialSetNames;
}
constexpr std::string_view name(MonomialSet set) { return base::name_of(set); }

/// Tail of the density beyond the energy up to which Q_n is reliable.
enum class Tail {
  confined,  ///< the exponent is Q_n + Confinement: a density on the whole half-plane
  cut        ///< the exponent is Q_n alone, and the density is 0 beyond the same energy
};
inline constexpr base::EnumEntry<Tail> kTailNames[] = {{Tail::confined, "confined"},
                                                       {Tail::cut, "cut"}};
constexpr std::span<const base::EnumEntry<Tail>> names(Tail) { return kTailNames; }
constexpr std::string_view name(Tail tail) { return base::name_of(tail); }

struct Options {
  int order = 6;  ///< n of paper (18): even, 2 .. greatest_order
  Formulation formulation = Formulation::gaussian;
  MonomialSet monomials = MonomialSet::point_symmetric;  ///< of the formulation gaussian
  std::optional<Equation> equation = {};                 ///< automatic: default_equation
  Tail tail = Tail::confined;                            ///< of the formulation moment
  /// Tolerance on the residual. gaussian: largest projection (23) relative to
  /// gaussian::residual_unit; moment, polar: half_plane::residual_norm.
  double tolerance = 1e-10;
  /// Largest L1 error of p(y) and of p(y') against the full problem with which a solution is ok.
  /// The closure itself has no error estimate: the caller measures the error. Empty (files of
  /// earlier programs): the caller does not.
  std::optional<double> accuracy = 2e-2;
  /// Limit on Newton steps. gaussian: plain steps from equivalent linearisation; moment, polar:
  /// steps at each order.
  int max_iterations = 30;
  /// Deadline of moment and polar: no further attempt at a root begins after these seconds.
  double max_seconds = 20;
};

/// Names, help and ranges of the options on the command line and in files.
const base::Description<Options>& description();

/// @throws InputError with the option, its value and the allowed values
void validate(const Options& options);

/// Largest order that double precision supports; rounding dominates at higher orders.
int greatest_order(Formulation formulation);

/// Equation without the option: km4 for gaussian; kf for moment and polar.
Equation default_equation(Formulation formulation);

/// Equation of the options, the default if none was chosen.
Equation equation_of(const Options& options);

/// Id of the solution, such as epc-gaussian-n6, epc-gaussian-white-n4, epc-moment-cut-n8. The id
/// contains the equation only if it is not the formulation's default.
std::string id(const Options& options);

/// Options of an id, which need not be valid. Empty for an id of another method.
std::optional<Options> options_of(std::string_view id);

/// Identity of the solution. Its formulation is the part of the id between "epc-" and "-nN".
transform::Identity identity(const Options& options);

}  // namespace fpkcheck::epc
