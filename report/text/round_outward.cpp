#include "report/text/round_outward.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::report {

IntervalText round_outward(double lower, double upper) {
  constexpr int kMostDecimals = 15;  // all digits of a double of order 1
  const double width = upper - lower;
  if (!std::isfinite(width)) return {fmt::format("{}", lower), fmt::format("{}", upper)};
  const int decimals =
      width > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(width))), 0, kMostDecimals)
                : kMostDecimals;
  const double unit = std::pow(10.0, decimals);
  // The exact product may lie above or below the integer to which the product is rounded: fma gives
  // the sign of the rounding error.
  double down = std::floor(lower * unit), up = std::ceil(upper * unit);
  if (down == lower * unit && std::fma(lower, unit, -down) < 0) down -= 1;
  if (up == upper * unit && std::fma(upper, unit, -up) > 0) up += 1;
  return {fmt::format("{:.{}f}", down / unit, decimals),
          fmt::format("{:.{}f}", up / unit, decimals)};
}

}  // namespace fpkcheck::report
