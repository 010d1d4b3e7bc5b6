#include <array>
#include <cmath>
#include <type_traits>

#include "numerics/simd/elementary_functions.hpp"
#include "problem/expression/expression.hpp"

namespace fpkcheck::problem {
namespace {

using Real = simd::VectorTypes<Expression::kBatch>::Real;
using Mask = decltype(Real{} < Real{});

consteval const Function* function_named(std::string_view name) {
  for (const Function& function : kFunctions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}
constexpr const Function *kAbs = function_named("abs"), *kMax = function_named("max"),
                         *kMin = function_named("min"), *kSqrt = function_named("sqrt"),
                         *kExp = function_named("exp"), *kTanh = function_named("tanh"),
                         *kSinh = function_named("sinh"), *kCosh = function_named("cosh");

FPKCHECK_INLINE Real absolute(const Real& x) { return x < 0.0 ? -x : x; }

// Largest argument of simd::exponential().
constexpr double kLargestExponent = 700;
// Below this argument the series of sinh and tanh replace differences of exponentials.
constexpr double kSmall = 0.06;

FPKCHECK_INLINE Real clamped_exponential(const Real& x) {
  const Real limit = simd::broadcast<Real>(kLargestExponent);
  return simd::exponential(simd::lanewise_max(simd::lanewise_min(x, limit), -limit));
}

FPKCHECK_INLINE Real tanh_of(const Real& x) {
  const Real e = clamped_exponential(-2.0 * absolute(x));
  const Real magnitude = (1.0 - e) / (1.0 + e);
  const Real x2 = x * x;
  const Real series =
      x * (1.0 - x2 * (1.0 / 3 - x2 * (2.0 / 15 - x2 * (17.0 / 315 - x2 * (62.0 / 2835)))));
  return absolute(x) < kSmall ? series : x < 0.0 ? -magnitude : magnitude;
}

FPKCHECK_INLINE Real sinh_of(const Real& x) {
  const Real e = clamped_exponential(x);
  const Real x2 = x * x;
  const Real series = x * (1.0 + x2 * (1.0 / 6 + x2 * (1.0 / 120 + x2 * (1.0 / 5040))));
  return absolute(x) < kSmall ? series : 0.5 * (e - 1.0 / e);
}

FPKCHECK_INLINE Real cosh_of(const Real& x) {
  const Real e = clamped_exponential(x);
  return 0.5 * (e + 1.0 / e);
}

FPKCHECK_INLINE void call(const Function& f, std::size_t count, Real& a, const Real& b) {
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
    Mask computed{};
    if (&f == kTanh || &f == kExp || &f == kSinh || &f == kCosh) {
      computed = absolute(x) < kLargestExponent;
      a = &f == kTanh   ? tanh_of(x)
          : &f == kExp  ? clamped_exponential(x)
          : &f == kSinh ? sinh_of(x)
                        : cosh_of(x);
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (computed[k] == 0) a[k] = f.value(x[k], b[k]);
    }
  }
}

// Values and derivatives with respect to v of a batch of points, as numerics::DualNumber. The members
// have no initial values, so that an evaluation does not set its whole stack to zero.
struct DualBatch {
  Real value, derivative;

  FPKCHECK_INLINE friend DualBatch operator+(const DualBatch& a, const DualBatch& b) {
    return {a.value + b.value, a.derivative + b.derivative};
  }
  FPKCHECK_INLINE friend DualBatch operator-(const DualBatch& a, const DualBatch& b) {
    return {a.value - b.value, a.derivative - b.derivative};
  }
  FPKCHECK_INLINE friend DualBatch operator-(const DualBatch& a) {
    return {-a.value, -a.derivative};
  }
  FPKCHECK_INLINE friend DualBatch operator*(const DualBatch& a, const DualBatch& b) {
    return {a.value * b.value, a.derivative * b.value + a.value * b.derivative};
  }
  FPKCHECK_INLINE friend DualBatch operator/(const DualBatch& a, const DualBatch& b) {
    const Real quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
  }
};

template <class Number>
FPKCHECK_INLINE Number constant_of(double value) {
  if constexpr (std::is_same_v<Number, Real>) {
    return simd::broadcast<Real>(value);
  } else {
    return {simd::broadcast<Real>(value), Real{}};
  }
}

// Returns slope * derivative, and 0 where the derivative is 0, for an infinite slope too.
FPKCHECK_INLINE Real chain_rule(const Real& slope, const Real& derivative) {
  return derivative == 0.0 ? Real{} : slope * derivative;
}

FPKCHECK_INLINE void call(const Function& f, std::size_t count, DualBatch& a, const DualBatch& b) {
  const Real x = a.value, one = simd::broadcast<Real>(1);
  call(f, count, a.value, b.value);
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
      a.derivative[k] = apply(f, numerics::DualNumber{x[k], a.derivative[k]},
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

// Returns base^(n/2).
FPKCHECK_INLINE Real half_integer_power_of(const Real& base, int n) {
  return integer_power_of(simd::square_root(base), n);
}
FPKCHECK_INLINE DualBatch half_integer_power_of(const DualBatch& base, int n) {
  return {half_integer_power_of(base.value, n),
          chain_rule(0.5 * n * half_integer_power_of(base.value, n - 2), base.derivative)};
}

FPKCHECK_INLINE void raise_to_power(Real& base, const Real& exponent, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) base[k] = real_power(base[k], exponent[k]);
}
FPKCHECK_INLINE void raise_to_power(DualBatch& base, const DualBatch& exponent, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const numerics::DualNumber power =
        real_power(numerics::DualNumber{base.value[k], base.derivative[k]},
                   numerics::DualNumber{exponent.value[k], exponent.derivative[k]});
    base.value[k] = power.value;
    base.derivative[k] = power.derivative;
  }
}

// Constant exponents above this limit are computed by the library.
constexpr double kLargestHalfInteger = 8;

FPKCHECK_INLINE Real load(std::size_t count, const double* numbers) {
  if (count == Expression::kBatch) return simd::load<Real>(numbers);
  Real batch{};
  for (std::size_t k = 0; k < Expression::kBatch; ++k) batch[k] = numbers[k < count ? k : 0];
  return batch;
}

}  // namespace

template <class Number>
FPKCHECK_INLINE Number Expression::evaluate_lanes(const Number& y, const Number& v,
                                                  std::size_t count) const {
  std::array<Number, kMaxDepth + 1> stack;
  stack[0] = y;  // A formula has at least one node, which GCC 12 does not see.
  std::size_t top = 0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Node& node = nodes_[k];
    switch (node.operation) {
      case Operation::constant:
        stack[top++] = constant_of<Number>(node.constant);
        break;
      case Operation::y:
        stack[top++] = y;
        break;
      case Operation::v:
        stack[top++] = v;
        break;
      case Operation::add:
        --top;
        stack[top - 1] = stack[top - 1] + stack[top];
        break;
      case Operation::subtract:
        --top;
        stack[top - 1] = stack[top - 1] - stack[top];
        break;
      case Operation::multiply:
        --top;
        stack[top - 1] = stack[top - 1] * stack[top];
        break;
      case Operation::divide:
        --top;
        stack[top - 1] = stack[top - 1] / stack[top];
        break;
      case Operation::negate:
        stack[top - 1] = -stack[top - 1];
        break;
      case Operation::power: {
        if (node.has_integer_exponent) {
          stack[top - 1] = integer_power_of(stack[top - 1], static_cast<int>(node.constant));
          break;
        }
        --top;
        const Node& exponent = nodes_[k - 1];
        const double doubled = 2 * exponent.constant;
        if (exponent.operation == Operation::constant && doubled == std::trunc(doubled) &&
            std::abs(exponent.constant) < kLargestHalfInteger) {
          stack[top - 1] = half_integer_power_of(stack[top - 1], static_cast<int>(doubled));
          break;
        }
        raise_to_power(stack[top - 1], stack[top], count);
        break;
      }
      case Operation::call:
        if (node.function->arguments == 2) --top;
        call(*node.function, count, stack[top - 1],
             stack[node.function->arguments == 2 ? top : top - 1]);
        break;
    }
  }
  return stack[0];
}

// One version for each instruction set, all with the same bits; the loader selects one. With Clang 14
// the versions neither compile nor link: only the version of the baseline exists.
#if defined(__x86_64__) && defined(__linux__) && !defined(__clang__)
#define FPKCHECK_VERSIONS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FPKCHECK_VERSIONS
#endif

FPKCHECK_VERSIONS void Expression::evaluate_batch(std::size_t count, const double* y,
                                                  const double* v, double* values) const {
  const Real result = evaluate_lanes<Real>(load(count, y), load(count, v), count);
  for (std::size_t k = 0; k < count; ++k) values[k] = result[k];
}

FPKCHECK_VERSIONS void Expression::evaluate_batch_with_slopes_in_v(std::size_t count,
                                                                   const double* y, const double* v,
                                                                   double* values,
                                                                   double* slopes) const {
  const auto [value, derivative] = evaluate_lanes<DualBatch>(
      {load(count, y), Real{}}, {load(count, v), simd::broadcast<Real>(1)}, count);
  for (std::size_t k = 0; k < count; ++k) {
    values[k] = value[k];
    slopes[k] = derivative[k];
  }
}

}  // namespace fpkcheck::problem
