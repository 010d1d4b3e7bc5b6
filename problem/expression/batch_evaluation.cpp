#include <array>
#include <cmath>

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

FPKCHECK_INLINE Real integer_power_of(const Real& base, int exponent) {
  Real factor = base, power = simd::broadcast<Real>(1);
  for (int n = std::abs(exponent); n > 0; n >>= 1, factor = factor * factor) {
    if ((n & 1) != 0) power = power * factor;
  }
  return exponent < 0 ? 1.0 / power : power;
}

// Constant exponents above this limit are computed by the library.
constexpr double kLargestHalfInteger = 8;

}  // namespace

// One version for each instruction set, all with the same bits; the loader selects one. With Clang 14
// the versions neither compile nor link: only the version of the baseline exists.
#if defined(__x86_64__) && defined(__linux__) && !defined(__clang__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
void Expression::evaluate_batch(std::size_t count, const double* ys, const double* vs,
                                double* values) const {
  Real y{}, v{};
  for (std::size_t k = 0; k < kBatch; ++k) {
    y[k] = ys[k < count ? k : 0];
    v[k] = vs[k < count ? k : 0];
  }
  std::array<Real, kMaxDepth + 1> stack;
  std::size_t top = 0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Node& node = nodes_[k];
    switch (node.operation) {
      case Operation::constant:
        stack[top++] = simd::broadcast<Real>(node.constant);
        break;
      case Operation::y:
        stack[top++] = y;
        break;
      case Operation::v:
        stack[top++] = v;
        break;
      case Operation::add:
        --top;
        stack[top - 1] += stack[top];
        break;
      case Operation::subtract:
        --top;
        stack[top - 1] -= stack[top];
        break;
      case Operation::multiply:
        --top;
        stack[top - 1] *= stack[top];
        break;
      case Operation::divide:
        --top;
        stack[top - 1] /= stack[top];
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
          stack[top - 1] =
              integer_power_of(simd::square_root(stack[top - 1]), static_cast<int>(doubled));
          break;
        }
        for (std::size_t n = 0; n < count; ++n) {
          stack[top - 1][n] = std::pow(stack[top - 1][n], stack[top][n]);
        }
        break;
      }
      case Operation::call:
        if (node.function->arguments == 2) --top;
        call(*node.function, count, stack[top - 1],
             stack[node.function->arguments == 2 ? top : top - 1]);
        break;
    }
  }
  for (std::size_t k = 0; k < count; ++k) values[k] = stack[0][k];
}

}  // namespace fpkcheck::problem
