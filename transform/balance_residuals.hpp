#pragma once

#include <optional>

#include "transform/observation.hpp"

namespace fpkcheck::transform {

/// Relative residuals of the identities of problem/motion_balances.hpp: 0 for the exact stationary
/// density of any equation and impact. Nothing where a solution lacks what an identity needs. They
/// accuse and do not acquit: what misses an identity is wrong, what meets it may be wrong elsewhere.
struct BalanceResiduals {
  std::optional<double> virial = {};    ///< problem::virial_balance
  std::optional<double> momentum = {};  ///< problem::momentum_balance
};

/// Adds "balances.virial" and "balances.momentum", null where there are none, and the standard
/// errors that there are as "balances.virial_error", "balances.momentum_error". None is a part of
/// the answer to which a repeated run is held: moments are.
void observe(Observer& observer, const BalanceResiduals& residuals,
             const BalanceResiduals& standard_errors = {});

}  // namespace fpkcheck::transform
