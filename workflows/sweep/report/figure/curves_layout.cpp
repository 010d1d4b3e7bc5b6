#include "workflows/sweep/report/figure/curves_layout.hpp"

#include <algorithm>
#include <numeric>

namespace fpkcheck::sweep {

CurvesLayout curves_layout(const Plan& plan) {
  const std::size_t along = plan.axes.size() == 2 && KeyAxis(plan, 0).has_words() ? 1 : 0;
  CurvesLayout layout{KeyAxis(plan, along), along, {}};
  if (plan.axes.size() == 1) {
    layout.slices.push_back({"", std::vector<std::size_t>(plan.points.size())});
    std::iota(layout.slices[0].points.begin(), layout.slices[0].points.end(), std::size_t{0});
  } else {
    const KeyAxis across(plan, 1 - along);
    for (const auto& value : across.values()) {
      layout.slices.push_back({KeyAxis::value_text(value), {}});
    }
    for (std::size_t point = 0; point < plan.points.size(); ++point) {
      layout.slices[across.cell_index(plan.points[point][1 - along])].points.push_back(point);
    }
  }
  for (auto& slice : layout.slices) {
    std::ranges::sort(slice.points, {}, [&](std::size_t point) {
      return layout.along.coordinate(plan.points[point][along]);
    });
  }
  return layout;
}

}  // namespace fpkcheck::sweep
