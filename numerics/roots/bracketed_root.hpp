#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cassert>
#include <cstdint>

namespace fpkcheck::numerics {

/// Computes the root of a continuous function in [low, high] by inverse cubic interpolation with
/// bracketing (Alefeld, Potra and Shi, ACM Transactions on Mathematical Software 21 (1995) 327).
/// @pre the signs of f(low) and f(high) differ, or f(low) or f(high) is 0
/// @param bits number of correct bits of the computed root
template <class Function>
double bracketed_root(const Function& f, double low, double high, int bits = 52) {
  const double at_low = f(low), at_high = f(high);
  assert(at_low == 0 || at_high == 0 || (at_low < 0) != (at_high < 0));
  std::uintmax_t iterations = 200;
  const auto [left, right] = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(bits), iterations);
  return (left + right) / 2;
}

}  // namespace fpkcheck::numerics
