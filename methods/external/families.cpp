#include "methods/external/families.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "methods/look.hpp"

namespace fpkcheck::methods {
namespace {

constexpr std::string_view kSeparators = "-_.";

bool is_separator(char c) { return kSeparators.find(c) != std::string_view::npos; }

// "chi" for the label "chi-n4" with order 4; no value where the label does not end with the order.
std::optional<std::string> family_name(const transform::Identity& identity) {
  if (!identity.order) return std::nullopt;
  std::string_view name = identity.id;
  const std::string order = std::to_string(*identity.order);
  if (!name.ends_with(order)) return std::nullopt;
  name.remove_suffix(order.size());
  if (name.size() > 1 && name.back() == 'n' && is_separator(name[name.size() - 2])) {
    name.remove_suffix(1);
  }
  while (!name.empty() && is_separator(name.back())) name.remove_suffix(1);
  // "chi12" is not order 2 of "chi1".
  if (name.empty() || ('0' <= name.back() && name.back() <= '9')) return std::nullopt;
  return std::string(name);
}

}  // namespace

void join_families(std::span<Method> guests) {
  for (std::size_t first = 0; first < guests.size(); ++first) {
    const auto name = family_name(guests[first].identity);
    if (!name || guests[first].identity.family == *name) continue;
    const auto is_member = [&](const Method& guest) { return family_name(guest.identity) == name; };
    if (std::ranges::count_if(guests, is_member) < 2) continue;
    for (Method& guest : guests) {
      if (!is_member(guest)) continue;
      guest.identity.family = *name;
      guest.identity.plot_style = given_family_look(first, *guest.identity.order);
    }
  }
}

}  // namespace fpkcheck::methods
