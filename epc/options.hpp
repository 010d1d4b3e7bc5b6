#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/options/description.hpp"
#include "problem/model.hpp"
#include "transform/identity.hpp"

/// Exponential-polynomial closure: a density C exp(Q_n) whose coefficients meet weak moment
/// equations.
namespace fpkcheck::epc {

using problem::Equation;
using problem::Impact;

/// What the unknowns and the equations are.
enum class Formulation {
  gaussian,  ///< the paper's (17)-(26): projections under Gaussian weights in the (z, z') plane
  moment,    ///< exact moment equations on the half-plane y >= 0, see epc/moment/
  /// The same with Q_n in amplitude and phase, see epc/polar/; where the mass rests in contact with a
  /// wall, in amplitude and velocity over the energy, see epc/contact/.
  polar
};
inline constexpr base::Named<Formulation> kFormulationNames[] = {
    {Formulation::gaussian, "gaussian", "the paper's projections under Gaussian weights"},
    {Formulation::moment, "moment", "exact moment equations on the half-plane"},
    {Formulation::polar, "polar", "the same in amplitude and phase, or velocity"}};
constexpr std::span<const base::Named<Formulation>> names(Formulation) { return kFormulationNames; }
constexpr std::string_view name(Formulation formulation) { return base::name_of(formulation); }

/// Which monomials x1^p x2^q make up Q_n and the projections of the formulation gaussian.
enum class MonomialSet {
  point_symmetric,  ///< p + q = 2, 4, .. n: all that survives (x1, x2) -> (-x1, -x2)
  general           ///< p + q = 1, 2, .. n, paper (18)
};
inline constexpr base::Named<MonomialSet> kMonomialSetNames[] = {
    {MonomialSet::point_symmetric, "point_symmetric"}, {MonomialSet::general, "general"}};
constexpr std::span<const base::Named<MonomialSet>> names(MonomialSet) { return kMonomialSetNames; }
constexpr std::string_view name(MonomialSet set) { return base::name_of(set); }

/// What the density does where Q_n cannot be trusted any more.
enum class Tail {
  confined,  ///< the exponent is Q_n + Confinement: a density on the whole half-plane
  cut        ///< the exponent is Q_n alone, and the half-plane is cut off at the same energy
};
inline constexpr base::Named<Tail> kTailNames[] = {{Tail::confined, "confined"},
                                                   {Tail::cut, "cut"}};
constexpr std::span<const base::Named<Tail>> names(Tail) { return kTailNames; }
constexpr std::string_view name(Tail tail) { return base::name_of(tail); }

struct Options {
  int order = 6;  ///< n of paper (18): even, 2 .. greatest_order
  Formulation formulation = Formulation::gaussian;
  MonomialSet monomials = MonomialSet::point_symmetric;  ///< of the formulation gaussian
  std::optional<Equation> equation = {};                 ///< automatic: usual_equation
  Tail tail = Tail::confined;                            ///< of the formulation moment
  /// On the largest projection (23), relative to gaussian::residual_unit; moment, polar: on
  /// half_plane::size_of.
  double tolerance = 1e-10;
  /// Largest error of p(y) and of p(y') in L1, against the full problem, with which a solution is
  /// ok. A closure cannot tell its error: who calls measures it, or does not where this is empty, as
  /// in files of earlier programs.
  std::optional<double> accuracy = 2e-2;
  /// Of Newton's method: gaussian: plain steps from equivalent linearisation; moment, polar: at
  /// each order.
  int max_iterations = 30;
  /// Of moment and polar: after so long no further way to a root is begun.
  double max_seconds = 20;
};

/// The options as the command line and files name them.
const base::Description<Options>& description();

/// @throws InputError naming the option, its value and what is allowed
void validate(const Options& options);

/// Double precision carries the equations up to these orders; beyond them rounding shows.
int greatest_order(Formulation formulation);

/// What a formulation solves unless it is told otherwise: gaussian: km4; moment, polar: kf.
Equation usual_equation(Formulation formulation);

/// The equation that is solved.
Equation equation_of(const Options& options);

/// The solution's id, such as epc-gaussian-n6, epc-gaussian-white-n4, epc-moment-cut-n8: the
/// equation is named where it is not the formulation's usual one.
std::string id(const Options& options);

/// The options of an id; they need not be valid. Nothing where it is no closure's.
std::optional<Options> options_of(std::string_view id);

/// Which solution the options ask for. Its formulation is what stands between "epc-" and "-nN" of
/// its id.
transform::Identity identity(const Options& options);

}  // namespace fpkcheck::epc
