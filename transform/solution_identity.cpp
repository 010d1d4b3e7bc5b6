#include "transform/solution_identity.hpp"

#include <fmt/format.h>

namespace fpkcheck::transform {

bool is_external(const SolutionIdentity& identity) {
  return identity.method == kExternalFile || identity.method == kExternalFunction;
}

bool differs_by_order_in_family(const SolutionIdentity& identity) {
  if (!identity.order) return false;
  return is_external(identity) ? identity.family != identity.method
                               : identity.role == SolutionRole::closure;
}

std::string equation_and_impact_text(const SolutionIdentity& identity) {
  return fmt::format("{}/{}", identity.equation ? name(*identity.equation) : "given",
                     identity.impact ? name(*identity.impact) : "-");
}

std::string solution_name_within_family(const SolutionIdentity& identity) {
  if (identity.order) return fmt::format("n{}", *identity.order);
  const std::string prefix = identity.method + "-";
  return identity.id.starts_with(prefix) ? identity.id.substr(prefix.size()) : identity.id;
}

}  // namespace fpkcheck::transform
