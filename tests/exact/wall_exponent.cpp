#include "exact/wall_exponent.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::exact {

double wall_exponent(double restitution) {
  if (!(restitution > problem::kCollapseRestitution && restitution <= 1)) {
    throw InputError(
        fmt::format("restitution = {}: no wall exponent is known; use a value above {:.4f}, where "
                    "impacts do not accumulate, and at most 1",
                    restitution, problem::kCollapseRestitution));
  }
  // (2 - beta) log r + log(2 sin((2 beta + 1) pi / 6)) is concave in beta, since sin is
  // log-concave. Its value is 2 log r <= 0 at beta = 0, and 0 at beta = 2 with the slope
  // -log r - pi / sqrt 3 < 0. The function is therefore positive just below 2, and the other root
  // is its only change of sign.
  const auto excess = [&](double beta) {
    return (2 - beta) * std::log(restitution) +
           std::log(2 * std::sin((2 * beta + 1) * std::numbers::pi / 6));
  };
  // The upper end of the bisection is the maximum, where (pi/3) cot((2 beta + 1) pi / 6) = log r.
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
