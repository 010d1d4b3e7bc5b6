#pragma once

#include <array>
#include <boost/numeric/interval.hpp>
#include <cfenv>
#include <span>
#include <vector>

#include "numerics/interval/enclosure.hpp"

/// Outward-rounded interval arithmetic with Boost.Interval.
///
/// Include the header interval.hpp only in targets that are compiled with -frounding-math
/// -ffp-contract=off (`numerics`, `backward` and the tests of these two targets). Without these
/// compiler options, interval arithmetic may be rounded in the wrong direction, and the linker may
/// keep the wrong copy of a template. All interval arithmetic must run inside
/// call_with_upward_rounding(). The lower end of a result x is computed as -up(-x), where `up` is
/// upward rounding.
namespace fpkcheck::numerics {

/// Rounding control of the calling thread, with the interface that Boost's rounded_arith_opp
/// requires. The function force_rounding() does not store results to memory, since SSE2 arithmetic
/// has no excess precision.
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

/// Boost's interval arithmetic under upward rounding, except for the lower end of the square root.
/// For the lower end of a square root, Boost changes the rounding mode within an expression, and
/// the compiler may compute the square root before the change. UpwardArithmetic computes the lower
/// end of a square root as s - 2^-52 s, where s is the upper end and 2^-52 s is at least one unit
/// in the last place.
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

/// Guard object that sets the rounding mode of the thread to upward rounding for its lifetime.
/// @throws std::runtime_error if setting the rounding mode has no effect on this processor or in
/// this build
class UpwardRounding {
 public:
  UpwardRounding();
  ~UpwardRounding();
  UpwardRounding(const UpwardRounding&) = delete;
  UpwardRounding& operator=(const UpwardRounding&) = delete;

 private:
  int before_;
};

/// Calls the function `work` in such a way that the compiler neither inlines nor analyses the call.
/// Without inlining, the compiler cannot move arithmetic of `work` out of the lifetime of an
/// UpwardRounding object.
template <class Work>
#if defined(__GNUC__) && !defined(__clang__)
[[gnu::noipa]]
#else
[[gnu::noinline]]
#endif
auto call_without_inlining(const Work& work) {
  return work();
}
template <class Work>
auto call_with_upward_rounding(const Work& work) {
  const UpwardRounding upward;
  return call_without_inlining(work);
}

inline Interval interval_from_enclosure(const Enclosure& e) { return {e.lower, e.upper}; }
inline Enclosure enclosure_from_interval(const Interval& x) { return {x.lower(), x.upper()}; }

inline Interval symmetric_interval(double x) { return {-x, x}; }
/// Returns the largest absolute value of the elements of an interval x.
inline double magnitude(const Interval& x) { return std::max(-x.lower(), x.upper()); }

/// Returns an enclosure of the power x^n of an interval x, n >= 0, as a product of n factors. For
/// even n and an interval that contains 0, the lower end of the enclosure may be negative.
Interval power(const Interval& x, int n);
/// Returns an enclosure of e^x, computed by the Taylor series with its remainder on [-1/4, 1/4] and
/// by repeated squaring.
/// @pre x <= 0
Interval exponential(const Interval& x);

/// Interval coefficients b_0 .. b_n, in Bernstein form, of the polynomial sum_j b_j C(n, j) t^j
/// (1-t)^(n-j), 0 <= t <= 1 (Farouki, Computer Aided Geometric Design 29 (2012) 379). The values of
/// a polynomial lie between its smallest and its largest Bernstein coefficient.
using BernsteinCoefficients = std::vector<Interval>;

/// Returns the binomial coefficient C(n, j), exact for n <= 40.
double binomial_coefficient(int n, int j);

BernsteinCoefficients elevate_bernstein_degree(std::span<const Interval> bernstein_coefficients,
                                               int degree);
BernsteinCoefficients bernstein_product(std::span<const Interval> a, std::span<const Interval> b);
BernsteinCoefficients bernstein_derivative(std::span<const Interval> bernstein_coefficients);
/// Evaluates a polynomial in Bernstein form at a point t in [0, 1] by de Casteljau's algorithm.
Interval evaluate_bernstein_polynomial(std::span<const Interval> bernstein_coefficients,
                                       const Interval& t);

/// Returns the Bernstein coefficients b_0 .. b_n of the polynomial sum_k a_k t^k of degree n.
BernsteinCoefficients bernstein_from_power_coefficients(std::span<const Interval> a);
/// Returns the coefficients a_k of the polynomial sum_k a_k t^k that has the given Bernstein
/// coefficients.
BernsteinCoefficients power_coefficients_from_bernstein(
    std::span<const Interval> bernstein_coefficients);
/// Returns the Bernstein coefficients of the polynomial sum_k a_k (x - origin)^k on the segment x =
/// from + t (to - from), 0 <= t <= 1.
BernsteinCoefficients bernstein_coefficients_on_segment(std::span<const double> a,
                                                        const Interval& origin,
                                                        const Interval& from, const Interval& to);

}  // namespace fpkcheck::numerics
