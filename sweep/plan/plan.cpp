#include "sweep/plan/plan.hpp"

#include <algorithm>
#include <stdexcept>

namespace fpkcheck::sweep {

problem::Problem Plan::problem_at(std::size_t point) const {
  auto sections = problem::sections(base);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const std::string& key = axes[a].key;
    const auto dot = key.find('.');
    const auto section = std::ranges::find(sections, key.substr(0, dot), &problem::Section::name);
    if (section == sections.end()) throw std::logic_error("no section of " + key);
    const auto value =
        std::ranges::find(section->values, key.substr(dot + 1), &parameters::NamedValue::name);
    if (value == section->values.end()) throw std::logic_error("no parameter " + key);
    value->value = points[point][a];
  }
  return problem::problem_from(base.name, sections);
}

}  // namespace fpkcheck::sweep
