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
  /// For `simulated`: standard error, NaN where a run does not state it. For `simulated_l1`:
  /// expected L1 by sampling, and its 99 % quantile.
  double error = 0, quantile_99 = 0;
  std::string part = {};  ///< name of the part that contains it: "density", "peaks[3]"
  /// True of the quantity that opens a part and holds its presence or length. A change of that
  /// quantity is reported once; the rest of the part is then not compared.
  bool opens_part = false;
};
using Quantities = std::vector<Quantity>;

/// Name of the part that contains all quantities of a solution.
inline constexpr const char* kWholeSolution = "solution";
/// Name of the part that contains the error estimates of a solution.
inline constexpr const char* kStatedError = "stated error";

/// Appends the quantities of one part of a solution to a list.
struct PartQuantities {
  Quantities& quantities;
  std::string solution, name;

  /// Appends the quantity that opens the part: its presence, or a value that identifies it. Must
  /// precede all other quantities of the part.
  const PartQuantities& begin(QuantityKind kind, const base::Value& what = "there",
                              const std::string& outer = kWholeSolution) const;
  void word(const std::string& of, const base::Value& value) const;
  /// Appends a number; a number that is not finite becomes an empty value, as in files. The
  /// reference is valid until the next quantity is appended.
  Quantity& number(const std::string& of, QuantityKind kind, double value, double allowed,
                   double scale = 1) const;
};

/// The finite number in a value of type double or integer; NaN for every other value.
double number_in(const base::Value& value);

/// Compares the quantities of two runs, paired by solution and name, and reports those that only
/// one run has. Errors that the baseline lacks are not reported: older programs did not write them.
std::vector<QuantityChange> compare_quantities(const std::string& case_name,
                                               const Quantities& baseline, const Quantities& now);

}  // namespace fpkcheck::check
