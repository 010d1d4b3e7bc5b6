#pragma once

#include <string>
#include <vector>

#include "base/options/value.hpp"
#include "workflows/check/figure.hpp"

namespace fpkcheck::check {

/// One thing that a run says of a solution, and how another run is held to it.
struct Claim {
  std::string solution = {};  ///< id
  std::string name = {};
  FigureKind kind = FigureKind::status;
  base::Value value = {};
  double allowed = 0;  ///< of a simulated L1: in standard errors beyond its expectation
  double scale = 1;    ///< the change is relative to it
  /// What chance does to it: of `simulated` its standard error, NaN where a run does not say; of
  /// `simulated_l1` the expectation, and what 99 runs of 100 stay below.
  double error = 0, in_99 = 0;
  std::string part = {};  ///< what it belongs to, a claim of its own: "density", "peaks[3]"
  /// Says that a part is there, or how long it is: of interest only where it is another, and then
  /// the rest of the part is not compared.
  bool is_head = false;
};
using Claims = std::vector<Claim>;

/// The part of a solution that all of it belongs to.
inline constexpr const char* kWhole = "solution";
/// The part that has the errors which a solution states of itself.
inline constexpr const char* kStatedError = "stated error";

/// Adds the claims on a part of a solution.
struct Part {
  Claims& claims;
  std::string solution, name;

  /// That the part is there, and what tells that it is the same: before all other claims on it.
  const Part& begin(FigureKind kind, const base::Value& what = "there",
                    const std::string& outer = kWhole) const;
  void word(const std::string& of, const base::Value& value) const;
  /// A number that is not finite is nothing, as in files. The claim stays until the next one.
  Claim& number(const std::string& of, FigureKind kind, double value, double allowed,
                double scale = 1) const;
};

/// The finite number that a value is, whole or not; NaN where it is none.
double number_in(const base::Value& value);

/// The claims of two runs, paired by solution and name, and what only one of them claims. Errors
/// that the baseline lacks are not missed, since older programs did not write them.
std::vector<Figure> held_against(const std::string& case_name, const Claims& baseline,
                                 const Claims& now);

}  // namespace fpkcheck::check
