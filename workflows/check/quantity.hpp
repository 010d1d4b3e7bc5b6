#pragma once

#include <string>
#include <vector>

#include "base/options/value.hpp"
#include "workflows/check/quantity_change.hpp"

namespace fpkcheck::check {

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
  /// the length of this part. If such a quantity changes, only this change is reported; all other
  /// quantities of the part are not compared.
  bool opens_part = false;
};
using Quantities = std::vector<Quantity>;

/// Name of the part that contains all quantities of a solution outside other parts.
inline constexpr const char* kWholeSolution = "solution";
/// Name of the part that contains the error estimates of a solution.
inline constexpr const char* kStatedError = "stated error";

/// A writer that appends the quantities of one part of a solution to a list. A part is a group of
/// quantities, such as the density or an element of a list of metrics.
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
