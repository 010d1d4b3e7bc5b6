#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "base/options/names.hpp"
#include "base/options/value.hpp"

namespace fpkcheck::check {

/// The change of a quantity that only one run has.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Kind of a compared quantity; the kind selects the unit and the tolerance of a change.
enum class FigureKind {
  status,          ///< status or another word: must be equal
  moment,          ///< relative; E[y'] relative to at least 1e-3 of the deviation of y'
  mass,            ///< absolute
  energy,          ///< energy residual (already relative to the power input), absolute
  coefficient,     ///< coefficient of a closure, relative
  distance,        ///< distance between densities, in units of the deviation of the variable
  tail,            ///< mean |log10| difference in a decade of the tail, absolute
  detail,          ///< metric of one method, relative, small values absolute
  budget,          ///< entry of the error budget, absolute
  marginal,        ///< bin of a marginal density with the largest change, relative to the peak
  simulated,       ///< moment, mass, rate, quantile.. of a simulation, in standard errors
  simulated_bin,   ///< bin of a simulated density with the largest change, in standard errors
  simulated_l1,    ///< L1 between two simulations, or change of an L1 to a simulation
  simulated_error  ///< error by sampling that a simulation states: ratio of the runs - 1
};
/// Labels for tables and check.json, and the unit of a change.
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

/// One quantity of the baseline and of the new run, with its change.
struct Figure {
  std::string case_name;
  std::string solution;  ///< id of the solution
  std::string name;      ///< e.g. "E[y^2]", "a(2,0)", "p(y) at 0.31", "L1 p(y') to fd-kf"
  FigureKind kind;
  base::Value baseline;  ///< a number, a word, a flag, or empty
  base::Value now;
  double change;  ///< not negative, in unit(kind); infinite where a comparison is impossible
  double allowed;

  bool moved() const { return !(change <= allowed); }
  /// The change in units of its tolerance.
  double share() const { return change == 0 ? 0 : change / allowed; }
};

}  // namespace fpkcheck::check
