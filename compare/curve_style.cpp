#include "compare/curve_style.hpp"

#include <algorithm>
#include <array>

namespace fpkcheck::compare {
namespace {

constexpr const char* kBlack = "#000000";
constexpr const char* kSkyBlue = "#56B4E9";
constexpr const char* kBlue = "#0072B2";
constexpr const char* kGreen = "#009E73";
constexpr const char* kOrange = "#E69F00";
constexpr const char* kVermillion = "#D55E00";
constexpr const char* kPurple = "#CC79A7";
constexpr const char* kGrey = "#606060";

constexpr const char* kSolid = "solid";

CurveStyle finite_differences(const std::string& id) {
  if (id == "fd-kf") return {kSkyBlue, kSolid, 5, false, 0};
  if (id == "fd-km4") return {kBlue, kSolid, 1.5, false, 1};
  if (id == "fd-white") return {kGreen, kSolid, 1.5, false, 1};
  return {kBlack, kSolid, 1, false, 1};
}

}  // namespace

CurveStyle curve_style(const nlohmann::ordered_json& solution) {
  const auto method = solution.at("method").get<std::string>();
  if (method == "mcs") return {kBlack, kSolid, 1, true, 3};
  if (method == "fd") return finite_differences(solution.at("id").get<std::string>());

  constexpr std::array kColours{kOrange, kVermillion, kPurple, kGrey};
  // The higher the order, the more ink.
  constexpr std::array kDashes{"(2,4)",          "(10,4)",     "(10,4,2,4)",
                               "(10,4,2,4,2,4)", "(20,4,2,4)", "(20,6)"};
  const auto step = static_cast<std::size_t>(std::max(2, solution.value("order", 2)) / 2 - 1);
  const bool moment = solution.value("formulation", std::string()) == "moment";
  return {kColours[(step + (moment ? 1 : 0)) % kColours.size()], kDashes[step % kDashes.size()], 2,
          false, 2};
}

}  // namespace fpkcheck::compare
