#include "workflows/sweep/result/sweep_results.hpp"

#include <algorithm>
#include <utility>

namespace fpkcheck::sweep {

SweepResults make_sweep_results(Plan plan, std::vector<PointResult> points) {
  std::ranges::sort(points, {}, &PointResult::point);
  return {std::move(plan), std::move(points)};
}

std::vector<std::string> SweepResults::budget_parts() const {
  std::vector<std::string> names;
  for (const auto& point : points) {
    for (const auto& method : point.methods) {
      for (const auto& share : method.budget) {
        if (std::ranges::find(names, share.part) == names.end()) names.push_back(share.part);
      }
    }
  }
  return names;
}

}  // namespace fpkcheck::sweep
