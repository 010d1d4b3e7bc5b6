// Fuzzer of formulas: the parser accepts or refuses a text; the evaluations of an accepted formula
// agree with one another.
#include "problem/expression/expression.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "fuzz_helpers.hpp"

namespace {

using namespace fpkcheck;
using problem::Expression;

constexpr double kUnit = std::numeric_limits<double>::epsilon();

/// A value with a bound of the rounding errors of all operations before; infinite where the bound
/// is unknown.
struct Bounded {
  double value = 0;
  double error = 0;
  bool is_extreme = false;  ///< whether an intermediate value may underflow or overflow

  static Bounded rounded(double value, double error, bool is_extreme) {
    const double magnitude = std::abs(value);
    error += 8 * kUnit * magnitude + std::numeric_limits<double>::denorm_min();
    if (!(error <= std::numeric_limits<double>::max())) {
      error = std::numeric_limits<double>::infinity();
    }
    const bool out = magnitude != 0 && !(magnitude > 1e-100 && magnitude < 1e100);
    return {value, error, is_extreme || out};
  }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return rounded(a.value + b.value, a.error + b.error, a.is_extreme || b.is_extreme);
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return rounded(a.value - b.value, a.error + b.error, a.is_extreme || b.is_extreme);
  }
  friend Bounded operator-(const Bounded& a) { return {-a.value, a.error, a.is_extreme}; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return rounded(a.value * b.value,
                   std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error,
                   a.is_extreme || b.is_extreme);
  }
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const double divisor = std::abs(b.value) - b.error;
    const double propagated = divisor > 0
                                  ? (a.error + std::abs(a.value / b.value) * b.error) / divisor
                                  : std::numeric_limits<double>::infinity();
    return rounded(a.value / b.value, propagated, a.is_extreme || b.is_extreme);
  }
};

// The largest change of f over the errors of its arguments, with a factor for the values between.
template <class Value>
Bounded changed(Value f, const Bounded& a, const Bounded& b) {
  const double value = f(a.value, b.value);
  double error = 0;
  for (const double da : {-a.error, 0.0, a.error}) {
    for (const double db : {-b.error, 0.0, b.error}) {
      const double change = std::abs(f(a.value + da, b.value + db) - value);
      error = change <= error ? error : change;  // NaN replaces every bound
      if (std::isnan(change)) return Bounded::rounded(value, change, true);
    }
  }
  // A periodic function, a pole or a jump may be between distant arguments.
  if (a.error > 1e-3 || b.error > 1e-3) error = std::numeric_limits<double>::infinity();
  return Bounded::rounded(value, 4 * error, a.is_extreme || b.is_extreme);
}

Bounded apply_named_function(const problem::NamedFunction& f, const Bounded& a, const Bounded& b) {
  return changed(f.value, a, f.arguments == 1 ? Bounded{} : b);
}
Bounded real_power(const Bounded& a, const Bounded& b) {
  return changed([](double x, double n) { return std::pow(x, n); }, a, b);
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void require_polynomial(const Expression& f, double y, double v) {
  const auto coefficients = f.polynomial_coefficients();
  const Bounded expected = f(Bounded{y}, Bounded{v});
  if (!coefficients || expected.is_extreme) return;
  double value = 0, magnitude = 0;
  for (const auto& [exponents, coefficient] : *coefficients) {
    fuzz::require(coefficient != 0);
    const double term = coefficient * std::pow(y, exponents.first) * std::pow(v, exponents.second);
    value += term;
    magnitude += std::abs(term);
  }
  // The expansion has errors of the same order as those of the terms before cancellation, at most
  // (|y| + |v|)^12 times those of the evaluation.
  const double expansion = std::pow(2 + std::abs(y) + std::abs(v), 12);
  fuzz::require(std::abs(value - expected.value) <=
                expansion * (expected.error + 100 * kUnit * magnitude));
}

void require_agreement(const Expression& f, const std::string& text) {
  std::mt19937_64 random(std::hash<std::string>{}(text));
  std::uniform_real_distribution<double> moderate(-3, 3), exponent(-300, 300);
  std::array<double, Expression::kBatchPoints> ys{0, 0.3, -40, 1e-9, 700},
      vs{0, -1.2, 300, 1, -1e-3};
  for (std::size_t n = 5; n < 7; ++n) ys[n] = moderate(random), vs[n] = moderate(random);
  ys[7] = std::pow(10, exponent(random));
  vs[7] = -std::pow(10, exponent(random));
  std::array<double, Expression::kBatchPoints> values{};
  f.evaluate_batch(ys.size(), ys.data(), vs.data(), values.data());
  const problem::FunctionParity parity = f.parity();
  for (std::size_t n = 0; n < ys.size(); ++n) {
    const double y = ys[n], v = vs[n], value = f(y, v);
    const numerics::DualNumber dual = f(numerics::DualNumber{y, 1}, numerics::DualNumber{v, 0});
    fuzz::require(same(dual.value, value));
    if (!f.depends_on_y()) fuzz::require(same(f(-y - 1, v), value));
    if (!f.depends_on_v()) fuzz::require(same(f(y, -v - 1), value));
    double alone = 0;
    f.evaluate_batch(1, &y, &v, &alone);
    fuzz::require(same(alone, values[n]));
    const Bounded bounded = f(Bounded{y}, Bounded{v});
    fuzz::require(same(bounded.value, value));
    if (!std::isfinite(bounded.error)) continue;
    fuzz::require(std::abs(values[n] - value) <= bounded.error);
    if (parity == problem::FunctionParity::none) continue;
    const double mirrored = f(-y, -v);
    const double expected = parity == problem::FunctionParity::odd ? -value : value;
    fuzz::require(std::abs(mirrored - expected) <= 2 * bounded.error);
  }
  for (std::size_t n = 5; n < 7; ++n) require_polynomial(f, ys[n], vs[n]);
}

void require_sorted_inside(const std::vector<double>& kinks, double low, double high) {
  for (std::size_t n = 0; n < kinks.size(); ++n) {
    fuzz::require(kinks[n] >= low && kinks[n] <= high && (n == 0 || kinks[n] > kinks[n - 1]));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::as_text(data, size));
  try {
    const Expression f = Expression::parse(text, {{"mu", 0.1}, {"k", 2.0}}, "f");
    fuzz::require(text.size() <= Expression::kMaxLength);
    require_agreement(f, text);
    require_sorted_inside(f.kinks_in_y(-3, 4), -3, 4);
    require_sorted_inside(f.kinks_in_v(-3, 4), -3, 4);
    f.has_kinks_along_other_curves();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    fuzz::require(message.starts_with("f ") && message.size() < 500 &&
                  message.find('\n') == message.npos);
  }
  return 0;
}
