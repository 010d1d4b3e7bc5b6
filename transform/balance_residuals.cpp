#include "transform/balance_residuals.hpp"

#include <string>
#include <utility>

namespace fpkcheck::transform {

void observe(Observer& observer, const BalanceResiduals& residuals,
             const BalanceResiduals& standard_errors) {
  constexpr std::pair<const char*, std::optional<double> BalanceResiduals::*> kIdentities[] = {
      {"balances.virial", &BalanceResiduals::virial},
      {"balances.momentum", &BalanceResiduals::momentum}};
  for (const auto& [path, identity] : kIdentities) {
    const auto& error = standard_errors.*identity;
    const std::string error_path = std::string(path) + "_error";
    observer.add({.path = path,
                  .value = value_of(residuals.*identity),
                  .kind = Kind::work,
                  .error_at = error ? error_path : ""});
    if (error) observer.error(error_path, *error);
  }
}

}  // namespace fpkcheck::transform
