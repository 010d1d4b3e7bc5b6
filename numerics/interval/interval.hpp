#pragma once

#include <boost/numeric/interval.hpp>
#include <cfenv>

#include "numerics/interval/enclosure.hpp"

/// Outward-rounded interval arithmetic by Boost.Interval.
///
/// Only for this room and its tests, which are compiled with -frounding-math -ffp-contract=off:
/// elsewhere the compiler may evaluate in the wrong direction, and the linker may keep the wrong
/// copy of a template. Every use stands inside `rounded_upward`, which sets the thread's rounding
/// mode once; lower ends are computed as -(upward rounding of the opposite).
namespace fpkcheck::numerics {

/// The rounding mode of this thread, for Boost's rounded_arith_opp. SSE2 arithmetic has no excess
/// precision, so nothing needs to be forced to memory.
struct HardwareRounding {
  using rounding_mode = int;
  static void get_rounding_mode(rounding_mode& mode) { mode = std::fegetround(); }
  static void set_rounding_mode(rounding_mode mode) { std::fesetround(mode); }
  static void upward() { std::fesetround(FE_UPWARD); }
  static void downward() { std::fesetround(FE_DOWNWARD); }
  static void to_nearest() { std::fesetround(FE_TONEAREST); }
  static double force_rounding(double x) { return x; }
  static double to_int(double x) { return x; }
};

/// Boost's arithmetic under upward rounding. Only its lower end of a square root would switch the
/// mode within an expression, where the compiler may move the root before the switch: here it is
/// the upper end s less one unit in the last place, at most 2^-52 s.
struct UpwardArithmetic
    : boost::numeric::interval_lib::rounded_arith_opp<double, HardwareRounding> {
  double sqrt_down(const double& x) {
    const double s = sqrt_up(x);
    return -(s * 0x1p-52 - s);
  }
};

using Interval =
    boost::numeric::interval<double,
                             boost::numeric::interval_lib::policies<
                                 boost::numeric::interval_lib::save_state_nothing<UpwardArithmetic>,
                                 boost::numeric::interval_lib::checking_base<double>>>;

/// Sets rounding upward for its lifetime.
/// @throws std::runtime_error when this processor or this compilation does not obey
class UpwardRounding {
 public:
  UpwardRounding();
  ~UpwardRounding();
  UpwardRounding(const UpwardRounding&) = delete;
  UpwardRounding& operator=(const UpwardRounding&) = delete;

 private:
  int before_;
};

/// Calls `work` with upward rounding. It is a call that the compiler cannot see through, so that no
/// arithmetic of `work` moves out of the guard.
template <class Work>
#if defined(__GNUC__) && !defined(__clang__)
[[gnu::noipa]]
#else
[[gnu::noinline]]
#endif
auto called(const Work& work) {
  return work();
}
template <class Work>
auto rounded_upward(const Work& work) {
  const UpwardRounding upward;
  return called(work);
}

inline Interval interval(const Enclosure& e) { return {e.lower, e.upper}; }
inline Enclosure enclosure(const Interval& x) { return {x.lower(), x.upper()}; }

/// [-x, x]
inline Interval plus_minus(double x) { return {-x, x}; }
/// The largest |x| in the interval.
inline double magnitude(const Interval& x) { return std::max(-x.lower(), x.upper()); }

/// x^n, n >= 0, as a product: for even n no tighter than x * x where x contains 0.
Interval power(const Interval& x, int n);
/// e^x. The exponential series on [-1/4, 1/4] with its remainder, squared as often as needed.
/// @pre x <= 0
Interval exponential(const Interval& x);

}  // namespace fpkcheck::numerics
