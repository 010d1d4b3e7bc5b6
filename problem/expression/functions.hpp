#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace fpkcheck::problem {

/// Parity of a function f(x, y, ..) under a change of the sign of all arguments.
enum class FunctionParity { even, odd, none };

/// A function of one or two arguments that a formula can call.
struct NamedFunction {
  using Value = double (*)(double a, double b);
  std::string_view name;
  int arguments;          ///< 1 or 2; functions of one argument ignore b
  Value value;            ///< f(a, b)
  Value slope;            ///< df/da
  Value slope_in_second;  ///< df/db; null for functions of one argument
  FunctionParity parity = FunctionParity::none;
  /// A function of the arguments a and b that changes its sign where the function f(a, b) or its
  /// slope jumps; null for a smooth function.
  Value kink = nullptr;
};

/// All functions that a formula can call. A new function needs one entry in kFunctions.
inline constexpr std::array kFunctions{
    NamedFunction{"abs", 1, [](double a, double) { return std::abs(a); },
                  [](double a, double) { return a < 0   ? -1.0
                                                : a > 0 ? 1.0
                                                        : 0.0; }, nullptr,
                  FunctionParity::even, [](double a, double) { return a; }},
    NamedFunction{"sign", 1, [](double a, double) { return a < 0   ? -1.0
                                                           : a > 0 ? 1.0
                                                                   : 0.0; },
                  [](double, double) { return 0.0; }, nullptr, FunctionParity::odd,
                  [](double a, double) { return a; }},
    // The comparison a != a is true for NaN, so that max and min return NaN for a = NaN.
    NamedFunction{"max", 2, [](double a, double b) { return a > b || a != a ? a : b; },
                  [](double a, double b) { return a >= b ? 1.0 : 0.0; },
                  [](double a, double b) { return a >= b ? 0.0 : 1.0; }, FunctionParity::none,
                  [](double a, double b) { return a - b; }},
    NamedFunction{"min", 2, [](double a, double b) { return a < b || a != a ? a : b; },
                  [](double a, double b) { return a <= b ? 1.0 : 0.0; },
                  [](double a, double b) { return a <= b ? 0.0 : 1.0; }, FunctionParity::none,
                  [](double a, double b) { return a - b; }},
    NamedFunction{"sqrt", 1, [](double a, double) { return std::sqrt(a); },
                  [](double a, double) { return 0.5 / std::sqrt(a); }, nullptr},
    NamedFunction{"exp", 1, [](double a, double) { return std::exp(a); },
                  [](double a, double) { return std::exp(a); }, nullptr},
    NamedFunction{"log", 1, [](double a, double) { return std::log(a); },
                  [](double a, double) { return 1 / a; }, nullptr},
    NamedFunction{"sin", 1, [](double a, double) { return std::sin(a); },
                  [](double a, double) { return std::cos(a); }, nullptr, FunctionParity::odd},
    NamedFunction{"cos", 1, [](double a, double) { return std::cos(a); },
                  [](double a, double) { return -std::sin(a); }, nullptr, FunctionParity::even},
    NamedFunction{"tan", 1, [](double a, double) { return std::tan(a); },
                  [](double a, double) { return 1 + std::tan(a) * std::tan(a); }, nullptr,
                  FunctionParity::odd},
    NamedFunction{"atan", 1, [](double a, double) { return std::atan(a); },
                  [](double a, double) { return 1 / (1 + a * a); }, nullptr, FunctionParity::odd},
    NamedFunction{"sinh", 1, [](double a, double) { return std::sinh(a); },
                  [](double a, double) { return std::cosh(a); }, nullptr, FunctionParity::odd},
    NamedFunction{"cosh", 1, [](double a, double) { return std::cosh(a); },
                  [](double a, double) { return std::sinh(a); }, nullptr, FunctionParity::even},
    NamedFunction{"tanh", 1, [](double a, double) { return std::tanh(a); },
                  [](double a, double) { return 1 - std::tanh(a) * std::tanh(a); }, nullptr,
                  FunctionParity::odd},
    NamedFunction{"erf", 1, [](double a, double) { return std::erf(a); },
                  [](double a, double) { return 2 * std::numbers::inv_sqrtpi * std::exp(-a * a); },
                  nullptr, FunctionParity::odd},
    NamedFunction{"erfc", 1, [](double a, double) { return std::erfc(a); },
                  [](double a, double) { return -2 * std::numbers::inv_sqrtpi * std::exp(-a * a); },
                  nullptr},
};

}  // namespace fpkcheck::problem
