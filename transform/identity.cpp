#include "transform/identity.hpp"

#include <fmt/format.h>

namespace fpkcheck::transform {

bool is_guest(const Identity& identity) {
  return identity.method == kGivenInFile || identity.method == kGivenAsFunction;
}

bool is_by_order(const Identity& identity) {
  if (!identity.order) return false;
  return is_guest(identity) ? identity.family != identity.method : identity.role == Role::closure;
}

std::string solves_text(const Identity& identity) {
  return fmt::format("{}/{}", identity.equation ? name(*identity.equation) : "given",
                     identity.impact ? name(*identity.impact) : "-");
}

std::string short_name(const Identity& identity) {
  if (identity.order) return fmt::format("n{}", *identity.order);
  const std::string prefix = identity.method + "-";
  return identity.id.starts_with(prefix) ? identity.id.substr(prefix.size()) : identity.id;
}

}  // namespace fpkcheck::transform
