#include "compare/figure/content.hpp"

#include <algorithm>

#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

const MarginalCurve* find_curve(std::span<const MarginalCurve> curves, const std::string& solution,
                                const std::string& variable) {
  const auto found = std::ranges::find_if(curves, [&](const auto& curve) {
    return curve.solution == solution && curve.variable == variable;
  });
  return found == curves.end() ? nullptr : &*found;
}

// The solution of the full equation has no noise, so it comes before the simulation.
std::string choose_reference(const Json& summary_case, std::span<const MarginalCurve> curves) {
  for (const std::string id : {"fd-kf", "mcs"}) {
    const Json* solution = find_solution(summary_case, id);
    if (solution && is_ok(*solution) && find_curve(curves, id, "y") &&
        find_curve(curves, id, "ydot")) {
      return id;
    }
  }
  return "";
}

std::vector<double> difference(const MarginalCurve& curve, const MarginalCurve& reference) {
  if (curve.abscissa != reference.abscissa) return {};
  std::vector<double> result;
  for (std::size_t k = 0; k < curve.density.size(); ++k) {
    result.push_back(curve.density[k] - reference.density[k]);
  }
  return result;
}

FigureSide make_side(const Json& summary_case, std::span<const MarginalCurve> curves,
                     const std::string& variable, const std::string& reference) {
  FigureSide side{variable, {}, {}};
  const MarginalCurve* subtracted = find_curve(curves, reference, variable);
  for (const auto& solution : summary_case.at("solutions")) {
    const auto* curve = find_curve(curves, solution.at("id").get<std::string>(), variable);
    if (!curve) continue;
    side.curves.push_back({&solution, curve_style(solution), curve,
                           subtracted ? difference(*curve, *subtracted) : std::vector<double>{}});
  }
  std::ranges::stable_sort(side.curves, {}, [](const auto& drawn) { return drawn.style.layer; });

  std::vector<DrawnCurve> trusted;
  std::ranges::copy_if(side.curves, std::back_inserter(trusted),
                       [](const auto& drawn) { return is_ok(*drawn.solution); });
  side.ranges = figure_ranges(trusted.empty() ? side.curves : trusted);
  return side;
}

}  // namespace

FigureContent figure_content(const Json& summary_case, std::span<const MarginalCurve> curves) {
  FigureContent content{choose_reference(summary_case, curves), {}};
  for (const std::string variable : {"y", "ydot"}) {
    auto side = make_side(summary_case, curves, variable, content.reference);
    if (!side.curves.empty()) content.sides.push_back(std::move(side));
  }
  return content;
}

}  // namespace fpkcheck::compare
