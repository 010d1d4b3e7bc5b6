#include "exact/wall_exponent.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "problem/inelastic_collapse.hpp"

namespace fpkcheck::exact {

double wall_exponent(double restitution) {
  if (!(restitution > problem::kCollapseRestitution && restitution <= 1)) {
    throw InputError(
        fmt::format("no exponent of the wall is known for restitution = {} (impacts accumulate up "
                    "to {:.4f}) take more, and at most 1",
                    restitution, problem::kCollapseRestitution));
  }
  // (2 - beta) log r + log(2 sin((2 beta + 1) pi / 6)) is concave in beta, as sin is log-concave. It
  // is log r <= 0 at beta = 0, and 0 at beta = 2 with the slope -log r - pi / sqrt 3 < 0: positive
  // before 2, and the other root is the only change of sign.
  const auto excess = [&](double beta) {
    return (2 - beta) * std::log(restitution) +
           std::log(2 * std::sin((2 * beta + 1) * std::numbers::pi / 6));
  };
  // The maximum, where the slope (pi/3) cot((2 beta + 1) pi / 6) is log r.
  double above =
      3 / std::numbers::pi * std::atan2(std::numbers::pi / 3, std::log(restitution)) - 0.5;
  double below = 0;
  while (true) {
    const double middle = (below + above) / 2;
    if (middle <= below || middle >= above) return middle;
    (excess(middle) < 0 ? below : above) = middle;
  }
}

}  // namespace fpkcheck::exact
