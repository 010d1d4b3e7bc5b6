#include "workflows/sweep/plan/plan.hpp"

#include <algorithm>

namespace fpkcheck::sweep {

problem::Problem Plan::problem_at(std::size_t point) const {
  auto sections = problem::sections(base);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const std::string& key = axes[a].key;
    const auto dot = key.find('.');
    auto section = std::ranges::find(sections, key.substr(0, dot), &problem::CaseFileSection::name);
    if (section == sections.end()) {
      section = sections.insert(section, {.name = key.substr(0, dot), .values = {}});
    }
    auto value =
        std::ranges::find(section->values, key.substr(dot + 1), &base::NamedParameterValue::name);
    if (value == section->values.end()) {  // an optional key that the base case leaves out
      value = section->values.insert(value, {.name = key.substr(dot + 1), .value = {}});
    }
    value->value = points[point][a];
  }
  return problem::problem_from_sections(base.name, sections);
}

}  // namespace fpkcheck::sweep
