#include "methods/look.hpp"

#include <algorithm>

namespace fpkcheck::methods {
namespace {

using problem::Equation;
using problem::Impact;
using transform::Identity;
using transform::Look;

constexpr const char* kBlack = "#000000";
constexpr const char* kSkyBlue = "#56B4E9";
constexpr const char* kBlue = "#0072B2";
constexpr const char* kGreen = "#009E73";

// The higher the order, the larger the drawn share of the line.
constexpr std::array kDashes{"(2,4)",          "(10,4)",     "(10,4,2,4)",
                             "(10,4,2,4,2,4)", "(20,4,2,4)", "(20,6)"};

constexpr const char* kOfEquations = "triangle-down";

// Index among the orders 2, 4, .. 12, limited to the number of dash patterns.
std::size_t place_of_order(int order) {
  return std::min(static_cast<std::size_t>(std::max(2, order) / 2 - 1), kDashes.size() - 1);
}

}  // namespace

Look closure_look(const Ramp& ramp, const Identity& identity, const std::string& symbol) {
  const auto shade = place_of_order(identity.order.value_or(2));
  return {.colour = ramp[shade],
          .dash = kDashes[shade],
          .width = 2,
          .as_points = false,
          .layer = 2,
          .symbol = symbol};
}

Look equation_look(const Identity& identity) {
  Look look{.colour = kBlack,
            .dash = "solid",
            .width = 1.5,
            .as_points = false,
            .layer = 1,
            .symbol = kOfEquations};
  if (identity.impact == Impact::delta) {
    look.dash = "(6,2)";
  } else if (identity.equation == Equation::kf) {
    look.colour = kSkyBlue;
    look.width = 5;
    look.layer = 0;
  } else if (identity.equation == Equation::km4) {
    look.colour = kBlue;
  } else if (identity.equation == Equation::white) {
    look.colour = kGreen;
    look.dash = "(1,2)";
    look.width = 2;
  }
  return look;
}

Look scheme_look(std::size_t place) {
  constexpr std::array kBlues{"#9ECAE1", "#4292C6", "#08519C", "#08306B"};
  const auto shade = std::min(place, kBlues.size() - 1);
  return {.colour = kBlues[shade],
          .dash = kDashes[shade],
          .width = 2,
          .as_points = false,
          .layer = 1,
          .symbol = kOfEquations};
}

Look simulation_look(const Identity&) {
  return {.colour = kBlack,
          .dash = "solid",
          .width = 1,
          .as_points = true,
          .layer = 3,
          .symbol = "circle"};
}

Look given_look(std::size_t place) {
  constexpr std::array kColours{"#DC050C", "#882E72", "#777777"};
  constexpr std::array kOfFiles{"(4,3)", "(8,3)", "(4,3,1,3)"};
  return {.colour = kColours[place % kColours.size()],
          .dash = kOfFiles[place % kOfFiles.size()],
          .width = 2.5,
          .as_points = false,
          .layer = 4,
          .symbol = "pentagon"};
}

Look given_family_look(std::size_t place, int order) {
  Look look = given_look(place);
  look.dash = kDashes[place_of_order(order)];
  return look;
}

}  // namespace fpkcheck::methods
