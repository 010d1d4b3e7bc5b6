#include "compare/figure/curve_style.hpp"

#include <algorithm>
#include <array>

namespace fpkcheck::compare {
namespace {

constexpr const char* kBlack = "#000000";
constexpr const char* kSkyBlue = "#56B4E9";
constexpr const char* kBlue = "#0072B2";
constexpr const char* kGreen = "#009E73";
// Of files, in the order they were given.
constexpr std::array kGiven{"#DC050C", "#882E72", "#777777"};

// One hue a formulation, darker with the order 2, 4, .. 12.
using Ramp = std::array<const char*, 6>;
constexpr Ramp kOrange{"#E69F00", "#D55E00", "#A63603", "#7F2704", "#5C1A02", "#3D1000"};
constexpr Ramp kPurple{"#E3A8C8", "#CC79A7", "#B3558C", "#8E3A73", "#6A2058", "#45103A"};
constexpr Ramp kOlive{"#C9C46A", "#A8A23A", "#87811F", "#66610F", "#4A4606", "#2E2B00"};

constexpr const char* kSolid = "solid";

CurveStyle finite_differences(const std::string& id) {
  if (id == "fd-kf") return {kSkyBlue, kSolid, 5, false, 0};
  if (id == "fd-km4") return {kBlue, kSolid, 1.5, false, 1};
  if (id == "fd-white") return {kGreen, kSolid, 1.5, false, 1};
  return {kBlack, kSolid, 1, false, 1};
}

const Ramp& ramp(const std::string& formulation) {
  if (formulation == "moment") return kPurple;
  if (formulation == "polar") return kOlive;
  return kOrange;
}

}  // namespace

CurveStyle curve_style(const nlohmann::ordered_json& solution) {
  const auto method = solution.at("method").get<std::string>();
  if (method == "mcs") return {kBlack, kSolid, 1, true, 3};
  if (method == "file") {
    return {kGiven[solution.value("place", std::size_t{0}) % kGiven.size()], "(4,3)", 2.5, false,
            4};
  }
  if (method == "fd") return finite_differences(solution.at("id").get<std::string>());

  // The higher the order, the more ink.
  constexpr std::array kDashes{"(2,4)",          "(10,4)",     "(10,4,2,4)",
                               "(10,4,2,4,2,4)", "(20,4,2,4)", "(20,6)"};
  const auto step = static_cast<std::size_t>(std::max(2, solution.value("order", 2)) / 2 - 1);
  const auto shade = std::min(step, kDashes.size() - 1);
  return {ramp(solution.value("formulation", std::string()))[shade], kDashes[shade], 2, false, 2};
}

}  // namespace fpkcheck::compare
