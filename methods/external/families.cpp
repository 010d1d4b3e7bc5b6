#include "methods/external/families.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "methods/plot_style.hpp"

namespace fpkcheck::methods {
namespace {

constexpr std::string_view kSeparators = "-_.";

bool is_separator(char c) { return kSeparators.find(c) != std::string_view::npos; }

// The common name in a label: "chi" for the label "chi-n4" of a density of order 4. Empty if the
// label does not end with the order.
std::optional<std::string> family_name(const transform::SolutionIdentity& identity) {
  if (!identity.order) return std::nullopt;
  std::string_view name = identity.id;
  const std::string order = std::to_string(*identity.order);
  if (!name.ends_with(order)) return std::nullopt;
  name.remove_suffix(order.size());
  if (name.size() > 1 && name.back() == 'n' && is_separator(name[name.size() - 2])) {
    name.remove_suffix(1);
  }
  while (!name.empty() && is_separator(name.back())) name.remove_suffix(1);
  // In "chi12" the number is 12: the label is not order 2 of the name "chi1".
  if (name.empty() || ('0' <= name.back() && name.back() <= '9')) return std::nullopt;
  return std::string(name);
}

}  // namespace

void group_families(std::span<Method> methods) {
  for (std::size_t first = 0; first < methods.size(); ++first) {
    const auto name = family_name(methods[first].identity);
    if (!name || methods[first].identity.family == *name) continue;
    const auto is_member = [&](const Method& method) {
      return family_name(method.identity) == name;
    };
    if (std::ranges::count_if(methods, is_member) < 2) continue;
    for (Method& method : methods) {
      if (!is_member(method)) continue;
      method.identity.family = *name;
      method.identity.plot_style = external_family_style(first, *method.identity.order);
    }
  }
}

}  // namespace fpkcheck::methods
