#include "methods/plot_style.hpp"

#include <algorithm>

namespace fpkcheck::methods {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using transform::PlotStyle;
using transform::SolutionIdentity;

constexpr const char* kBlack = "#000000";
constexpr const char* kSkyBlue = "#56B4E9";
constexpr const char* kBlue = "#0072B2";
constexpr const char* kGreen = "#009E73";

// Dash patterns by increasing order of the closure. The drawn fraction of a dashed line increases
// with the closure order.
constexpr std::array kDashes{"(2,4)",          "(10,4)",     "(10,4,2,4)",
                             "(10,4,2,4,2,4)", "(20,4,2,4)", "(20,6)"};

constexpr const char* kEquationMarker = "triangle-down";

// Returns the index of a closure order in the list 2, 4, .. 12, or the last index for higher
// orders.
std::size_t closure_order_index(int order) {
  return std::min(static_cast<std::size_t>(std::max(2, order) / 2 - 1), kDashes.size() - 1);
}

// Shades of the hue and plotly.js marker name of one formulation of closures.
struct ClosureFormulationStyle {
  const ColourRamp& ramp;
  const char* symbol;
};
constexpr ClosureFormulationStyle kGaussianStyle{kOrange, "triangle-up"},
    kMomentStyle{kPurple, "square"}, kPolarStyle{kOlive, "diamond"};

}  // namespace

PlotStyle closure_style(const SolutionIdentity& identity) {
  const std::string& formulation = identity.formulation;
  const auto& [ramp, symbol] = formulation.starts_with("moment")  ? kMomentStyle
                               : formulation.starts_with("polar") ? kPolarStyle
                                                                  : kGaussianStyle;
  const auto shade = closure_order_index(identity.order.value_or(2));
  return {.colour = ramp[shade], .dash = kDashes[shade], .width = 2, .layer = 2, .symbol = symbol};
}

PlotStyle density_equation_style(const SolutionIdentity& identity) {
  PlotStyle plot_style{.colour = kBlack, .symbol = kEquationMarker};
  if (identity.impact == ImpactCondition::delta) {
    plot_style.dash = "(6,2)";
  } else if (identity.equation == DensityEquation::kf) {
    plot_style.colour = kSkyBlue;
    plot_style.width = 5;
    plot_style.layer = 0;
  } else if (identity.equation == DensityEquation::km4) {
    plot_style.colour = kBlue;
  } else if (identity.equation == DensityEquation::white) {
    plot_style.colour = kGreen;
    plot_style.dash = "(1,2)";
    plot_style.width = 2;
  }
  return plot_style;
}

PlotStyle finite_volume_scheme_style(std::size_t rank) {
  constexpr std::array kBlues{"#9ECAE1", "#4292C6", "#08519C", "#08306B"};
  const auto shade = std::min(rank, kBlues.size() - 1);
  return {.colour = kBlues[shade], .dash = kDashes[shade], .width = 2, .symbol = kEquationMarker};
}

PlotStyle literature_method_style(std::size_t rank) {
  constexpr std::array kColours{"#8C510A", "#01665E", "#4D4D4D"};
  constexpr std::array kSymbols{"cross", "asterisk", "x"};
  constexpr std::array kDashPatterns{"(14,3)", "(3,3)", "(8,3)"};
  return {.colour = kColours.at(rank),
          .dash = kDashPatterns.at(rank),
          .width = 2,
          .layer = 2,
          .symbol = kSymbols.at(rank)};
}

PlotStyle simulation_style(const SolutionIdentity&) {
  return {.colour = kBlack, .width = 1, .as_points = true, .layer = 3, .symbol = "circle"};
}

PlotStyle external_density_style(std::size_t rank) {
  constexpr std::array kColours{"#DC050C", "#882E72", "#777777"};
  constexpr std::array kDashesOfFiles{"(4,3)", "(8,3)", "(4,3,1,3)"};
  return {.colour = kColours[rank % kColours.size()],
          .dash = kDashesOfFiles[rank % kDashesOfFiles.size()],
          .width = 2.5,
          .layer = 4,
          .symbol = "pentagon"};
}

PlotStyle external_family_style(std::size_t rank, int order) {
  PlotStyle plot_style = external_density_style(rank);
  plot_style.dash = kDashes[closure_order_index(order)];
  return plot_style;
}

}  // namespace fpkcheck::methods
