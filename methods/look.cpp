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

}  // namespace

Look closure_look(const Ramp& ramp, const Identity& identity, const std::string& symbol) {
  constexpr std::array kDashes{"(2,4)",          "(10,4)",     "(10,4,2,4)",
                               "(10,4,2,4,2,4)", "(20,4,2,4)", "(20,6)"};
  const auto step = static_cast<std::size_t>(std::max(2, identity.order.value_or(2)) / 2 - 1);
  const auto shade = std::min(step, kDashes.size() - 1);
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
            .symbol = "triangle-up"};
  if (identity.impact == Impact::delta) {
    look.width = 1;
  } else if (identity.equation == Equation::kf) {
    look.colour = kSkyBlue;
    look.width = 5;
    look.layer = 0;
  } else if (identity.equation == Equation::km4) {
    look.colour = kBlue;
  } else if (identity.equation == Equation::white) {
    look.colour = kGreen;
  }
  return look;
}

Look simulation_look(const Identity&) {
  return {
      .colour = kBlack, .dash = "solid", .width = 1, .as_points = true, .layer = 3, .symbol = "x"};
}

Look given_look(std::size_t place) {
  constexpr std::array kColours{"#DC050C", "#882E72", "#777777"};
  return {.colour = kColours[place % kColours.size()],
          .dash = "(4,3)",
          .width = 2.5,
          .as_points = false,
          .layer = 4,
          .symbol = "x"};
}

}  // namespace fpkcheck::methods
