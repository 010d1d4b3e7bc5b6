#pragma once

#include <cmath>
#include <numbers>

#include "transform/density.hpp"

namespace fpkcheck::tests {

inline constexpr double kSy = 0.6, kSv = 0.7;  // deviations, different from those of all cases

/// A half-Gaussian of y times a Gaussian of v.
inline transform::SmoothDensity bell() {
  return {[](double y, double v) {
            const double a = y / kSy, b = v / kSv;
            return std::exp(-(a * a + b * b) / 2) / (std::numbers::pi * kSy * kSv);
          },
          8 * kSy, 8 * kSv};
}

}  // namespace fpkcheck::tests
