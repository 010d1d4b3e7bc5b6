#include <array>
#include <cmath>
#include <type_traits>

#include "numerics/simd/elementary_functions.hpp"
#include "problem/expression/expression.hpp"

namespace fpkcheck::problem {
namespace {

consteval const NamedFunction* function_named(std::string_view name) {
  for (const NamedFunction& function : kFunctions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}
constexpr const NamedFunction *kAbs = function_named("abs"), *kMax = function_named("max"),
                              *kMin = function_named("min"), *kSqrt = function_named("sqrt"),
                              *kExp = function_named("exp"), *kTanh = function_named("tanh"),
                              *kSinh = function_named("sinh"), *kCosh = function_named("cosh");

template <class Real>
FPKCHECK_INLINE Real absolute(const Real& x) {
  return x < 0.0 ? -x : x;
}

// Largest magnitude of an argument of simd::exponential().
constexpr double kLargestExponent = 700;
// For arguments below kSmall, series replace the differences of exponentials in sinh and tanh.
constexpr double kSmall = 0.06;

template <class Real>
FPKCHECK_INLINE Real clamped_exponential(const Real& x) {
  const Real limit = simd::all_lanes_equal_to<Real>(kLargestExponent);
  return simd::exponential(simd::lanewise_max(simd::lanewise_min(x, limit), -limit));
}

template <class Real>
FPKCHECK_INLINE Real hyperbolic_tangent(const Real& x) {
  const Real e = clamped_exponential(-2.0 * absolute(x));
  const Real magnitude = (1.0 - e) / (1.0 + e);
  const Real x2 = x * x;
  const Real series =
      x * (1.0 - x2 * (1.0 / 3 - x2 * (2.0 / 15 - x2 * (17.0 / 315 - x2 * (62.0 / 2835)))));
  return absolute(x) < kSmall ? series : x < 0.0 ? -magnitude : magnitude;
}

template <class Real>
FPKCHECK_INLINE Real hyperbolic_sine(const Real& x) {
  const Real e = clamped_exponential(x);
  const Real x2 = x * x;
  const Real series = x * (1.0 + x2 * (1.0 / 6 + x2 * (1.0 / 120 + x2 * (1.0 / 5040))));
  return absolute(x) < kSmall ? series : 0.5 * (e - 1.0 / e);
}

template <class Real>
FPKCHECK_INLINE Real hyperbolic_cosine(const Real& x) {
  const Real e = clamped_exponential(x);
  return 0.5 * (e + 1.0 / e);
}

template <class Real>
FPKCHECK_INLINE void call_function(const NamedFunction& f, std::size_t count, Real& a,
                                   const Real& b) {
  if (&f == kAbs) {
    a = absolute(a);
  } else if (&f == kMax) {
    a = a > b ? a : a == a ? b : a;
  } else if (&f == kMin) {
    a = a < b ? a : a == a ? b : a;
  } else if (&f == kSqrt) {
    a = simd::square_root(a);
  } else {
    const Real x = a;
    decltype(x < x) computed{};
    if (&f == kTanh || &f == kExp || &f == kSinh || &f == kCosh) {
      computed = absolute(x) < kLargestExponent;
      a = &f == kTanh   ? hyperbolic_tangent(x)
          : &f == kExp  ? clamped_exponential(x)
          : &f == kSinh ? hyperbolic_sine(x)
                        : hyperbolic_cosine(x);
    }
    if (!simd::any_mask_lane_set(~computed)) return;
    for (std::size_t k = 0; k < count; ++k) {
      if (computed[k] == 0) a[k] = f.value(x[k], b[k]);
    }
  }
}

// Values and derivatives with respect to v of a batch of points, as numerics::DualNumber. The
// members of DualNumberBatch have no initial values, so that an evaluation does not set its whole
// stack to zero.
template <class Real>
struct DualNumberBatch {
  Real value, derivative;

  FPKCHECK_INLINE friend DualNumberBatch operator+(const DualNumberBatch& a,
                                                   const DualNumberBatch& b) {
    return {a.value + b.value, a.derivative + b.derivative};
  }
  FPKCHECK_INLINE friend DualNumberBatch operator-(const DualNumberBatch& a,
                                                   const DualNumberBatch& b) {
    return {a.value - b.value, a.derivative - b.derivative};
  }
  FPKCHECK_INLINE friend DualNumberBatch operator-(const DualNumberBatch& a) {
    return {-a.value, -a.derivative};
  }
  FPKCHECK_INLINE friend DualNumberBatch operator*(const DualNumberBatch& a,
                                                   const DualNumberBatch& b) {
    return {a.value * b.value, a.derivative * b.value + a.value * b.derivative};
  }
  FPKCHECK_INLINE friend DualNumberBatch operator/(const DualNumberBatch& a,
                                                   const DualNumberBatch& b) {
    const Real quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
  }
};

template <class Number>
FPKCHECK_INLINE Number constant_of(double value) {
  if constexpr (requires(Number number) { number.derivative; }) {
    using Real = decltype(Number::value);
    return {simd::all_lanes_equal_to<Real>(value), Real{}};
  } else {
    return simd::all_lanes_equal_to<Number>(value);
  }
}

// Returns the product slope * derivative of the chain rule, which is 0 for a zero derivative, even
// if the slope is infinite.
template <class Real>
FPKCHECK_INLINE Real chain_rule(const Real& slope, const Real& derivative) {
  return derivative == 0.0 ? Real{} : slope * derivative;
}

template <class Real>
FPKCHECK_INLINE void call_function(const NamedFunction& f, std::size_t count,
                                   DualNumberBatch<Real>& a, const DualNumberBatch<Real>& b) {
  const Real x = a.value, one = simd::all_lanes_equal_to<Real>(1);
  call_function(f, count, a.value, b.value);
  if (&f == kAbs) {
    a.derivative = x < 0.0 ? -a.derivative : x > 0.0 ? a.derivative : Real{};
  } else if (&f == kMax) {
    a.derivative = x >= b.value ? a.derivative : b.derivative;
  } else if (&f == kMin) {
    a.derivative = x <= b.value ? a.derivative : b.derivative;
  } else if (&f == kSqrt) {
    a.derivative = chain_rule(0.5 / a.value, a.derivative);
  } else if (&f == kExp) {
    a.derivative = chain_rule(a.value, a.derivative);
  } else if (&f == kTanh) {
    a.derivative = chain_rule(one - a.value * a.value, a.derivative);
  } else {
    for (std::size_t k = 0; k < count; ++k) {
      a.derivative[k] = apply_named_function(f, numerics::DualNumber{x[k], a.derivative[k]},
                                             numerics::DualNumber{b.value[k], b.derivative[k]})
                            .derivative;
    }
  }
}

template <class Number>
FPKCHECK_INLINE Number integer_power_of(const Number& base, int exponent) {
  Number factor = base, power = constant_of<Number>(1);
  for (int n = std::abs(exponent); n > 0; n >>= 1, factor = factor * factor) {
    if ((n & 1) != 0) power = power * factor;
  }
  return exponent < 0 ? constant_of<Number>(1) / power : power;
}

// Returns the power base^(n/2) of a number `base` and an integer n.
template <class Real>
FPKCHECK_INLINE Real half_integer_power_of(const Real& base, int n) {
  return integer_power_of(simd::square_root(base), n);
}
template <class Real>
FPKCHECK_INLINE DualNumberBatch<Real> half_integer_power_of(const DualNumberBatch<Real>& base,
                                                            int n) {
  return {half_integer_power_of(base.value, n),
          chain_rule(0.5 * n * half_integer_power_of(base.value, n - 2), base.derivative)};
}

template <class Real>
FPKCHECK_INLINE void raise_to_power(Real& base, const Real& exponent, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) base[k] = real_power(base[k], exponent[k]);
}
template <class Real>
FPKCHECK_INLINE void raise_to_power(DualNumberBatch<Real>& base,
                                    const DualNumberBatch<Real>& exponent, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const numerics::DualNumber power =
        real_power(numerics::DualNumber{base.value[k], base.derivative[k]},
                   numerics::DualNumber{exponent.value[k], exponent.derivative[k]});
    base.value[k] = power.value;
    base.derivative[k] = power.derivative;
  }
}

// Powers with constant exponents above kLargestHalfInteger are computed by the standard library.
constexpr double kLargestHalfInteger = 8;

// For at most kHalf points half a batch is evaluated, which fits into one register of AVX2.
constexpr std::size_t kHalf = Expression::kBatchPoints / 2;

template <class Real>
FPKCHECK_INLINE Real load_points(std::size_t count, const double* numbers) {
  constexpr std::size_t kWidth = simd::kWidth<Real>;
  if (count == kWidth) return simd::load<Real>(numbers);
  Real batch{};
  for (std::size_t k = 0; k < kWidth; ++k) batch[k] = numbers[k < count ? k : 0];
  return batch;
}

template <class Real>
FPKCHECK_INLINE void store_points(std::size_t count, const Real& batch, double* numbers) {
  if (count == simd::kWidth<Real>) return simd::store(batch, numbers);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = batch[k];
}

}  // namespace

template <class Number>
FPKCHECK_INLINE Number Expression::evaluate_simd_batch(const Number& y, const Number& v,
                                                       std::size_t count) const {
  // The value on top of the stack is a local variable, so that operations wait for no stores.
  Number top = y;
  std::array<Number, kMaxDepth + 1> below;
  std::size_t depth = 0;
  const auto push = [&](const Number& number) __attribute__((always_inline)) {
    below[depth++] = top;
    top = number;
  };
  for (const Node& node : nodes_) {
    switch (node.operation) {
      case Operation::constant:
        push(constant_of<Number>(node.constant));
        break;
      case Operation::y:
        push(y);
        break;
      case Operation::v:
        push(v);
        break;
      case Operation::add:
        top = below[--depth] + top;
        break;
      case Operation::subtract:
        top = below[--depth] - top;
        break;
      case Operation::multiply:
        top = below[--depth] * top;
        break;
      case Operation::divide:
        top = below[--depth] / top;
        break;
      case Operation::negate:
        top = -top;
        break;
      case Operation::power: {
        if (node.has_integer_exponent) {
          top = integer_power_of(top, static_cast<int>(node.constant));
          break;
        }
        const Number exponent = top;
        top = below[--depth];
        const Node& before = *(&node - 1);  // the last node of the exponent
        const double doubled = 2 * before.constant;
        if (before.operation == Operation::constant && doubled == std::trunc(doubled) &&
            std::abs(before.constant) < kLargestHalfInteger) {
          top = half_integer_power_of(top, static_cast<int>(doubled));
        } else {
          raise_to_power(top, exponent, count);
        }
        break;
      }
      case Operation::call: {
        const Number last = top;
        if (node.function->arguments == 2) top = below[--depth];
        call_function(*node.function, count, top, last);
        break;
      }
    }
  }
  return top;
}

// The compiler generates one version of the function for each instruction set, with equal results;
// the loader selects one version. With Clang 14 only the version for the baseline instruction set
// is compiled, since Clang 14 cannot link several versions of a function.
#if defined(__x86_64__) && defined(__linux__) && !defined(__clang__)
#define FPKCHECK_VERSIONS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FPKCHECK_VERSIONS
#endif

FPKCHECK_VERSIONS void Expression::evaluate_batch(std::size_t count, const double* y,
                                                  const double* v, double* values) const {
  using Whole = simd::SimdVectorTypes<kBatchPoints>::Real;
  using Half = simd::SimdVectorTypes<kHalf>::Real;
  if (count > kHalf) {
    store_points(
        count,
        evaluate_simd_batch(load_points<Whole>(count, y), load_points<Whole>(count, v), count),
        values);
  } else {
    store_points(
        count, evaluate_simd_batch(load_points<Half>(count, y), load_points<Half>(count, v), count),
        values);
  }
}

FPKCHECK_VERSIONS void Expression::evaluate_batch_with_velocity_slopes(
    std::size_t count, const double* y, const double* v, double* values, double* slopes) const {
  using Real = simd::SimdVectorTypes<kBatchPoints>::Real;
  const auto [value, derivative] = evaluate_simd_batch<DualNumberBatch<Real>>(
      {load_points<Real>(count, y), Real{}},
      {load_points<Real>(count, v), simd::all_lanes_equal_to<Real>(1)}, count);
  store_points(count, value, values);
  store_points(count, derivative, slopes);
}

}  // namespace fpkcheck::problem
