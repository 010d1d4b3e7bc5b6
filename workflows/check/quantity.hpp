#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "base/options/parameter.hpp"

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

/// One quantity of a solution in one run, with the tolerance for its change in another run.
struct Quantity {
  std::string solution = {};  ///< id of the solution
  std::string name = {};
  QuantityKind kind = QuantityKind::status;
  base::Value value = {};
  double allowed = 0;  ///< for `simulated_l1`: in deviations of the L1 beyond its expectation
  double scale = 1;    ///< changes are divided by this scale
  /// For the kind `simulated`: the standard error, NaN if the run states no standard error. For the
  /// kind `simulated_l1`: the expected L1 sampling error, and the 99 % quantile of this error.
  double error = 0, quantile_99 = 0;
  std::string part = {};  ///< name of the part that contains it: "density", "peaks[3]"
  /// Whether the quantity is the first of a part (a group of quantities) and states the presence or
  /// the length of the part. If the first quantity of a part changes, only this change is reported,
  /// and the other quantities of the part are not compared.
  bool opens_part = false;
};
using Quantities = std::vector<Quantity>;

/// Name of the part that contains all quantities of a solution outside other parts.
inline constexpr const char* kWholeSolution = "solution";
/// Name of the part that contains the error estimates of a solution.
inline constexpr const char* kStatedError = "stated error";

/// Appends the quantities of one part of a solution to a list. A part is a group of quantities,
/// such as the density or an element of a list of metrics.
struct PartQuantities {
  Quantities& quantities;
  std::string solution, name;

  /// Appends the first quantity of the part: the presence of the part, or a value that identifies
  /// the part. The first quantity of a part must be appended before all other quantities of the
  /// part.
  const PartQuantities& begin(QuantityKind kind, const base::Value& what = "there",
                              const std::string& outer = kWholeSolution) const;
  void append_word(const std::string& of, const base::Value& value) const;
  /// Appends a number; a number that is not finite becomes an empty value, as in files. The
  /// returned reference is valid until the next quantity is appended.
  Quantity& append_number(const std::string& of, QuantityKind kind, double value, double allowed,
                          double scale = 1) const;
};

/// The number in a value of type double or integer, if the number is finite; NaN for every other
/// value.
double number_in(const base::Value& value);

/// Compares the quantities of two runs in pairs with equal solution and name, and reports the
/// quantities that only one run has. Error estimates that the baseline lacks are not reported,
/// since older programs did not write these estimates.
std::vector<QuantityChange> compare_quantities(const std::string& case_name,
                                               const Quantities& baseline, const Quantities& now);

}  // namespace fpkcheck::check
