#pragma once

#include <optional>

#include "transform/metric.hpp"

namespace fpkcheck::transform {

/// Relative residuals of the identities of problem/motion_balances.hpp: 0 for the exact stationary
/// density of any equation and impact. Empty if the solution lacks a quantity of the identity.
/// A zero residual is necessary, not sufficient: a wrong density may satisfy both identities.
struct BalanceResiduals {
  std::optional<double> virial = {};    ///< problem::virial_balance
  std::optional<double> momentum = {};  ///< problem::momentum_balance
};

/// Adds the metrics "balances.virial" and "balances.momentum" (null if absent) and the standard
/// errors that are present, as "balances.virial_error" and "balances.momentum_error". All are
/// diagnostics: a repeated run need not reproduce them, since it must reproduce the moments.
void add_metrics(MetricBuilder& builder, const BalanceResiduals& residuals,
                 const BalanceResiduals& standard_errors = {});

}  // namespace fpkcheck::transform
