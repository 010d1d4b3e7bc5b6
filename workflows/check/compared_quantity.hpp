#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "base/options/parameter_value.hpp"

namespace fpkcheck::check {

/// Value of CheckedQuantityChange::change for a quantity that only one run has.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Kind of a compared quantity, which determines the unit and the tolerance of a change.
enum class CheckedQuantityKind {
  status,  ///< status or another word, which must be equal in the two runs
  /// Relative change of a moment of a solution; for E[y'] the divisor is at least 1e-3 standard
  /// deviations of y'.
  moment,
  mass,           ///< mass of a density, absolute change
  energy,         ///< energy residual (relative to the power input), absolute change
  coefficient,    ///< coefficient of a closure, relative change
  distance,       ///< distance between densities; unit: standard deviation of the variable
  tail,           ///< mean |log10| difference in a decade of the tail, absolute change
  detail,         ///< metric of one method, relative change, or absolute change of small values
  budget,         ///< entry of the error budget, absolute change
  marginal,       ///< bin of a marginal density with the largest change, relative to the peak
  simulated,      ///< moment, mass, rate or quantile of a simulation, in standard errors
  simulated_bin,  ///< bin of a simulated density with the largest change, in standard errors
  simulated_l1,   ///< L1 distance between two simulations, or change of an L1 distance
  /// Change of the sampling error of a simulation: the ratio of the errors in the two compared
  /// runs, minus 1.
  simulated_error
};
/// Label of each kind of compared quantity in tables and check.json, and unit of its change.
inline constexpr base::EnumEntry<CheckedQuantityKind> kQuantityKindNames[] = {
    {CheckedQuantityKind::status, "status and words"},
    {CheckedQuantityKind::moment, "moments", "relative"},
    {CheckedQuantityKind::mass, "mass", "absolute"},
    {CheckedQuantityKind::energy, "balance of power", "absolute"},
    {CheckedQuantityKind::coefficient, "coefficients", "relative"},
    {CheckedQuantityKind::distance, "distances", "absolute"},
    {CheckedQuantityKind::tail, "distances in tails", "absolute"},
    {CheckedQuantityKind::detail, "details", "relative"},
    {CheckedQuantityKind::budget, "error budget", "absolute"},
    {CheckedQuantityKind::marginal, "marginals", "of the peak"},
    {CheckedQuantityKind::simulated, "simulation", "std errors"},
    {CheckedQuantityKind::simulated_bin, "simulated bins", "std errors"},
    {CheckedQuantityKind::simulated_l1, "simulated L1", "absolute"},
    {CheckedQuantityKind::simulated_error, "simulation's errors", "relative"}};
constexpr std::span<const base::EnumEntry<CheckedQuantityKind>> enumerator_names(
    CheckedQuantityKind) {
  return kQuantityKindNames;
}
constexpr std::string_view name(CheckedQuantityKind kind) { return base::name_of(kind); }
constexpr std::string_view unit_of_change(CheckedQuantityKind kind) {
  return base::meaning_of(kind);
}

struct CheckedQuantityChange {
  std::string case_name;
  std::string solution;  ///< id of the solution
  std::string name;      ///< name of the quantity, e.g. "E[y^2]", "a(2,0)", "p(y) at 0.31"
  CheckedQuantityKind kind;
  base::Value baseline;  ///< value in the baseline: a number, a word, a flag, or empty
  base::Value now;
  /// Nonnegative change of a quantity between two runs, in the unit of its kind; infinite if the
  /// values cannot be compared.
  double change;
  double allowed;

  bool exceeds_tolerance() const { return !(change <= allowed); }
  double change_divided_by_tolerance() const { return change == 0 ? 0 : change / allowed; }
};

struct CheckedQuantity {
  std::string solution = {};  ///< id of the solution
  std::string name = {};
  CheckedQuantityKind kind = CheckedQuantityKind::status;
  base::Value value = {};
  /// Tolerance of the change between two runs; for the kind `simulated_l1` in standard deviations
  /// above the expected L1 distance.
  double allowed = 0;
  double scale = 1;  ///< number by which a change is divided
  /// The member `error` is the standard error of a quantity of kind `simulated`, or NaN if the run
  /// states no standard error. For the kind `simulated_l1`, `error` is the expected L1 sampling
  /// error, and `quantile_99` is the 99 % quantile of the L1 sampling error.
  double error = 0, quantile_99 = 0;
  std::string part = {};  ///< name of the part that contains the quantity, e.g. "peaks[3]"
  /// Whether the quantity states the presence or the length of a part of the solution, and precedes
  /// the other quantities of the part. If the presence or the length of a part of a solution
  /// changes, the other quantities of the part are not compared.
  bool opens_part = false;
};
using CheckedQuantities = std::vector<CheckedQuantity>;

/// Name of the part of compared quantities that represents the whole solution.
inline constexpr const char* kWholeSolutionPart = "solution";
/// Name of the part of compared quantities that contains the error estimates of a solution.
inline constexpr const char* kErrorEstimatePart = "stated error";

/// Appends the quantities of one part of a solution to a list. A part of a solution is, for
/// example, the density or an element of a list of metrics.
struct SolutionPartQuantityAppender {
  CheckedQuantities& quantities;
  std::string solution, name;

  /// Appends the first quantity of a part of a solution: the presence of the part, or a value that
  /// identifies the part. All other quantities of a part of a solution must be appended after the
  /// call of begin_part().
  const SolutionPartQuantityAppender& begin_part(
      CheckedQuantityKind kind, const base::Value& value = "there",
      const std::string& enclosing_part = kWholeSolutionPart) const;
  void append_word_quantity(const std::string& quantity_name, const base::Value& value) const;
  /// Appends a number as a quantity; a number that is not finite becomes an empty value, as in
  /// files. The returned reference to the quantity is valid until the next quantity is appended.
  CheckedQuantity& append_number_quantity(const std::string& quantity_name,
                                          CheckedQuantityKind kind, double value, double allowed,
                                          double scale = 1) const;
};

/// Returns the finite number in a value of type double or integer, otherwise NaN.
double finite_number_or_nan(const base::Value& value);

/// Compares the quantities of two runs with equal solution and name, and reports quantities that
/// only one run has. An error estimate that only the new run has is not reported, since older
/// program versions wrote no error estimates.
std::vector<CheckedQuantityChange> compare_quantities(const std::string& case_name,
                                                      const CheckedQuantities& baseline,
                                                      const CheckedQuantities& now);

}  // namespace fpkcheck::check
