#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::compare {

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
inline constexpr FigureKind kFigureKinds[] = {
    FigureKind::status,       FigureKind::moment,         FigureKind::mass,
    FigureKind::energy,       FigureKind::coefficient,    FigureKind::distance,
    FigureKind::tail,         FigureKind::detail,         FigureKind::budget,
    FigureKind::marginal,     FigureKind::simulated,      FigureKind::simulated_bin,
    FigureKind::simulated_l1, FigureKind::simulated_error};

/// In words, for tables and check.json: "status", "moments", ...
std::string_view name(FigureKind kind);
/// What its change is measured in: "relative", "of the peak", "standard errors", ...
std::string_view unit(FigureKind kind);

/// One number or word of a run beside that of the baseline.
struct Figure {
  std::string case_name;
  std::string solution;  ///< id
  std::string name;      ///< e.g. "E[y^2]", "a(2,0)", "p(y) at 0.31", "L1 p(y') to fd-kf"
  FigureKind kind;
  nlohmann::ordered_json baseline;  ///< the values: a number, a word, or null
  nlohmann::ordered_json now;
  double change;  ///< not negative, in unit(kind); infinite where the two cannot be compared
  double allowed;

  bool moved() const { return !(change <= allowed); }
};

}  // namespace fpkcheck::compare
