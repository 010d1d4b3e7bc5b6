#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "base/options/names.hpp"
#include "base/options/value.hpp"

namespace fpkcheck::check {

/// The change of what is there in one run alone.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a figure of a run is, and with that how it is judged.
enum class FigureKind {
  status,         ///< or another word: must be the same
  moment,         ///< relative; E[y'] to no less than a thousandth of a deviation
  mass,           ///< absolute, like the balance of power
  energy,         ///< residual of the balance of power, which is relative to the input
  coefficient,    ///< of a closure, relative
  distance,       ///< between densities, in the units of deviations of the variable
  tail,           ///< of a distance by decades, absolute
  detail,         ///< what only its method knows of a solution, relative, small ones absolute
  budget,         ///< of errors, absolute
  marginal,       ///< the bin that moved most, relative to the peak
  simulated,      ///< a simulation's moment, mass, rate, quantile.., in standard errors
  simulated_bin,  ///< the bin of a simulation that moved most, in standard errors
  simulated_l1,   ///< L1 between two simulations, or of a distance to one: what chance leaves of it
  simulated_error  ///< what a simulation says of its own errors: ratio of the runs - 1
};
/// In words, for tables and check.json; and what a change is measured in.
inline constexpr base::Named<FigureKind> kFigureKindNames[] = {
    {FigureKind::status, "status and words"},
    {FigureKind::moment, "moments", "relative"},
    {FigureKind::mass, "mass", "absolute"},
    {FigureKind::energy, "balance of power", "absolute"},
    {FigureKind::coefficient, "coefficients", "relative"},
    {FigureKind::distance, "distances", "absolute"},
    {FigureKind::tail, "distances in tails", "absolute"},
    {FigureKind::detail, "details", "relative"},
    {FigureKind::budget, "error budget", "absolute"},
    {FigureKind::marginal, "marginals", "of the peak"},
    {FigureKind::simulated, "simulation", "std errors"},
    {FigureKind::simulated_bin, "simulated bins", "std errors"},
    {FigureKind::simulated_l1, "simulated L1", "absolute"},
    {FigureKind::simulated_error, "simulation's errors", "relative"}};
constexpr std::span<const base::Named<FigureKind>> names(FigureKind) { return kFigureKindNames; }
constexpr std::string_view name(FigureKind kind) { return base::name_of(kind); }
constexpr std::string_view unit(FigureKind kind) { return base::meaning_of(kind); }

/// One number or word of a run beside that of the baseline.
struct Figure {
  std::string case_name;
  std::string solution;  ///< id
  std::string name;      ///< e.g. "E[y^2]", "a(2,0)", "p(y) at 0.31", "L1 p(y') to fd-kf"
  FigureKind kind;
  base::Value baseline;  ///< a number, a word, a flag, or nothing
  base::Value now;
  double change;  ///< not negative, in unit(kind); infinite where the two cannot be compared
  double allowed;

  bool moved() const { return !(change <= allowed); }
  /// How far beyond, or near, what is allowed.
  double share() const { return change == 0 ? 0 : change / allowed; }
};

}  // namespace fpkcheck::check
