#include "report/figure/content.hpp"

#include <algorithm>
#include <iterator>

#include "compare/reference.hpp"

namespace fpkcheck::report {
namespace {

using results::Case;
using results::Curve;
using transform::Variable;

// Nothing where it lacks one of the curves.
std::string reference_id(const Case& one) {
  const auto* reference = compare::reference(one.solutions);
  if (reference == nullptr) return "";
  const bool whole = std::ranges::all_of(transform::kVariables, [&](Variable variable) {
    return one.curve(reference->id(), variable) != nullptr;
  });
  return whole ? reference->id() : "";
}

std::vector<double> difference(const Curve& curve, const Curve* reference) {
  if (reference == nullptr || curve.abscissa != reference->abscissa) return {};
  std::vector<double> result;
  std::ranges::transform(curve.density, reference->density, std::back_inserter(result),
                         std::minus{});
  return result;
}

FigureSide make_side(const Case& one, Variable variable, const std::string& reference) {
  FigureSide side{variable, {}, {}};
  const Curve* subtracted = one.curve(reference, variable);
  for (const auto& solution : one.solutions) {
    if (const Curve* curve = one.curve(solution.id(), variable)) {
      side.curves.push_back({&solution, curve, difference(*curve, subtracted)});
    }
  }
  std::ranges::stable_sort(side.curves, {}, [](const auto& drawn) { return drawn.look().layer; });

  std::vector<DrawnCurve> trusted;
  std::ranges::copy_if(side.curves, std::back_inserter(trusted),
                       [](const auto& drawn) { return drawn.solution->is_ok(); });
  side.ranges = figure_ranges(trusted.empty() ? side.curves : trusted);
  return side;
}

}  // namespace

FigureContent figure_content(const Case& one) {
  FigureContent content{reference_id(one), {}};
  for (const auto variable : transform::kVariables) {
    auto side = make_side(one, variable, content.reference);
    if (!side.curves.empty()) content.sides.push_back(std::move(side));
  }
  return content;
}

}  // namespace fpkcheck::report
