#pragma once

#include <optional>

#include "transform/metric.hpp"

namespace fpkcheck::transform {

/// Relative residuals of the two balances of problem/motion_balances.hpp. A residual is 0 for the
/// exact stationary density of any density equation and impact condition, and empty if the solution
/// lacks a quantity of the balance. A zero residual is a necessary but not a sufficient condition
/// for the exact density: a wrong density may satisfy both balances.
struct BalanceResiduals {
  std::optional<double> virial = {};    ///< problem::virial_balance
  std::optional<double> momentum = {};  ///< problem::momentum_balance
};

/// Adds the residuals as metrics "balances.virial" and "balances.momentum" (null if a residual is
/// empty). Standard errors that are present are added as "balances.virial_error" and
/// "balances.momentum_error". All these metrics are diagnostics, so that a repeated run need not
/// reproduce their values; a repeated run must reproduce the moments.
void add_balance_metrics(MetricBuilder& builder, const BalanceResiduals& residuals,
                         const BalanceResiduals& standard_errors = {});

}  // namespace fpkcheck::transform
