#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "base/options/enum_names.hpp"
#include "base/options/value.hpp"

namespace fpkcheck::check {

/// The value of QuantityChange::change for a quantity that only one run has.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The kind of a compared quantity. The kind determines the unit and the tolerance of a change.
enum class QuantityKind {
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
/// The label of each kind in tables and check.json, and the unit of a change.
inline constexpr base::EnumEntry<QuantityKind> kQuantityKindNames[] = {
    {QuantityKind::status, "status and words"},
    {QuantityKind::moment, "moments", "relative"},
    {QuantityKind::mass, "mass", "absolute"},
    {QuantityKind::energy, "balance of power", "absolute"},
    {QuantityKind::coefficient, "coefficients", "relative"},
    {QuantityKind::distance, "distances", "absolute"},
    {QuantityKind::tail, "distances in tails", "absolute"},
    {QuantityKind::detail, "details", "relative"},
    {QuantityKind::budget, "error budget", "absolute"},
    {QuantityKind::marginal, "marginals", "of the peak"},
    {QuantityKind::simulated, "simulation", "std errors"},
    {QuantityKind::simulated_bin, "simulated bins", "std errors"},
    {QuantityKind::simulated_l1, "simulated L1", "absolute"},
    {QuantityKind::simulated_error, "simulation's errors", "relative"}};
constexpr std::span<const base::EnumEntry<QuantityKind>> enumerator_names(QuantityKind) {
  return kQuantityKindNames;
}
constexpr std::string_view name(QuantityKind kind) { return base::name_of(kind); }
constexpr std::string_view unit(QuantityKind kind) { return base::meaning_of(kind); }

/// One quantity with its values in the baseline and in the new run, and with its change.
struct QuantityChange {
  std::string case_name;
  std::string solution;  ///< id of the solution
  std::string name;      ///< e.g. "E[y^2]", "a(2,0)", "p(y) at 0.31", "L1 p(y') to fd-kf"
  QuantityKind kind;
  base::Value baseline;  ///< a number, a word, a flag, or empty
  base::Value now;
  double change;  ///< not negative, in unit(kind); infinite where a comparison is impossible
  double allowed;

  bool exceeds_tolerance() const { return !(change <= allowed); }
  /// The change of the quantity in units of the tolerance.
  double change_over_tolerance() const { return change == 0 ? 0 : change / allowed; }
};

}  // namespace fpkcheck::check
