#include "transform/balance_residuals.hpp"

#include <string>
#include <utility>

namespace fpkcheck::transform {

void add_balance_metrics(MetricBuilder& builder, const BalanceResiduals& residuals,
                         const BalanceResiduals& standard_errors) {
  constexpr std::pair<const char*, std::optional<double> BalanceResiduals::*> kIdentities[] = {
      {"balances.virial", &BalanceResiduals::virial},
      {"balances.momentum", &BalanceResiduals::momentum}};
  for (const auto& [path, identity] : kIdentities) {
    const auto& error = standard_errors.*identity;
    const std::string error_path = std::string(path) + "_error";
    builder.add({.path = path,
                 .value = value_from_optional(residuals.*identity),
                 .kind = MetricKind::work,
                 .standard_error_path = error ? error_path : ""});
    if (error) builder.add_error(error_path, *error);
  }
}

}  // namespace fpkcheck::transform
