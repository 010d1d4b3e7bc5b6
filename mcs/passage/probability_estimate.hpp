#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "transform/passage.hpp"

namespace fpkcheck::mcs {

/// Estimates a probability as the mean of `count` independent numbers between 0 and 1, such as the
/// indicators of an event. The standard error is that with two additional numbers 0 and two
/// additional numbers 1 (Agresti, Coull, The American Statistician 52 (1998) 119), so that it is
/// positive if all numbers are equal. For n numbers 0 two standard errors are 2.8/n, close to the
/// upper 95 % confidence limit 3/n of the probability (rule of three).
/// @param sum,square sum of the numbers, and sum of their squares
/// @pre count > 0
inline transform::ValueWithError probability_estimate(double count, double sum, double square) {
  assert(count > 0);
  constexpr double kAddedOnes = 2, kAddedZeros = 2;
  const double n = count + kAddedOnes + kAddedZeros, mean = (sum + kAddedOnes) / n;
  const double variance = std::max(0.0, (square + kAddedOnes) / n - mean * mean);
  return {sum / count, std::sqrt(variance / n)};
}

}  // namespace fpkcheck::mcs
