#include "compare/check/figure.hpp"

namespace fpkcheck::compare {

std::string_view name(FigureKind kind) {
  switch (kind) {
    case FigureKind::status:
      return "status and words";
    case FigureKind::moment:
      return "moments";
    case FigureKind::mass:
      return "mass";
    case FigureKind::energy:
      return "balance of power";
    case FigureKind::coefficient:
      return "coefficients";
    case FigureKind::distance:
      return "distances";
    case FigureKind::tail:
      return "distances in tails";
    case FigureKind::detail:
      return "details";
    case FigureKind::budget:
      return "error budget";
    case FigureKind::marginal:
      return "marginals";
    case FigureKind::simulated:
      return "simulation";
    case FigureKind::simulated_bin:
      return "simulated bins";
    case FigureKind::simulated_l1:
      return "simulated L1";
    case FigureKind::simulated_error:
      return "simulation's errors";
  }
  return "";
}

std::string_view unit(FigureKind kind) {
  switch (kind) {
    case FigureKind::moment:
    case FigureKind::coefficient:
    case FigureKind::detail:
    case FigureKind::simulated_error:
      return "relative";
    case FigureKind::marginal:
      return "of the peak";
    case FigureKind::simulated:
    case FigureKind::simulated_bin:
      return "std errors";
    case FigureKind::status:
      return "";
    default:
      return "absolute";
  }
}

}  // namespace fpkcheck::compare
