#pragma once

#include <boost/numeric/interval.hpp>
#include <cfenv>

#include "numerics/interval/enclosure.hpp"

/// Outward-rounded interval arithmetic by Boost.Interval.
///
/// Include only in targets compiled with -frounding-math -ffp-contract=off (this room, `backward`
/// and their tests). Otherwise the compiler may round in the wrong direction, and the linker may
/// keep the wrong copy of a template. All interval arithmetic runs inside `with_upward_rounding`,
/// which sets the thread's rounding mode once; lower ends are computed as -(upward rounding of the
/// opposite).
namespace fpkcheck::numerics {

/// Access to the rounding mode of this thread, for Boost's rounded_arith_opp. SSE2 arithmetic has
/// no excess precision, so results need not be forced to memory.
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

/// Boost's arithmetic under upward rounding. Boost's lower end of a square root switches the
/// rounding mode within an expression, and the compiler may move the root before the switch. Here
/// the lower end is the upper end s minus one unit in the last place, at most 2^-52 s.
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

/// Sets upward rounding during its lifetime.
/// @throws std::runtime_error when the rounding mode has no effect on this processor or in this
/// build
class UpwardRounding {
 public:
  UpwardRounding();
  ~UpwardRounding();
  UpwardRounding(const UpwardRounding&) = delete;
  UpwardRounding& operator=(const UpwardRounding&) = delete;

 private:
  int before_;
};

/// Calls `work` in a function that the compiler cannot analyse, so that no arithmetic of `work`
/// moves out of the guard.
template <class Work>
#if defined(__GNUC__) && !defined(__clang__)
[[gnu::noipa]]
#else
[[gnu::noinline]]
#endif
auto call_opaque(const Work& work) {
  return work();
}
template <class Work>
auto with_upward_rounding(const Work& work) {
  const UpwardRounding upward;
  return call_opaque(work);
}

inline Interval interval(const Enclosure& e) { return {e.lower, e.upper}; }
inline Enclosure enclosure(const Interval& x) { return {x.lower(), x.upper()}; }

/// [-x, x]
inline Interval symmetric_interval(double x) { return {-x, x}; }
/// The magnitude of an interval: its largest |x|.
inline double magnitude(const Interval& x) { return std::max(-x.lower(), x.upper()); }

/// x^n, n >= 0, as a product. For even n and x containing 0 no tighter than x * x.
Interval power(const Interval& x, int n);
/// e^x, by the exponential series on [-1/4, 1/4] with its remainder and repeated squaring.
/// @pre x <= 0
Interval exponential(const Interval& x);

}  // namespace fpkcheck::numerics
