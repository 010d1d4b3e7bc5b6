#pragma once

#include <cmath>
#include <numbers>

#include "transform/joint_density.hpp"

namespace fpkcheck::tests {

inline constexpr double kSigmaY = 0.6,
                        kSigmaV = 0.7;  // deviations, different from those of all cases

/// A half-Gaussian of y times a Gaussian of v.
inline transform::SmoothDensity gaussian_density() {
  return {[](double y, double v) {
            const double a = y / kSigmaY, b = v / kSigmaV;
            return std::exp(-(a * a + b * b) / 2) / (std::numbers::pi * kSigmaY * kSigmaV);
          },
          8 * kSigmaY, 8 * kSigmaV};
}

}  // namespace fpkcheck::tests
