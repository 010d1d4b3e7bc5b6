#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace fpkcheck::problem {

/// Parity of a function f(x, y, ..) under a change of the sign of all its arguments.
enum class Parity { even, odd, none };

/// A function of one or two arguments that an expression can call.
struct Function {
  using Value = double (*)(double a, double b);
  std::string_view name;
  int arguments;          ///< 1 or 2; functions of one argument ignore b
  Value value;            ///< f(a, b)
  Value slope;            ///< df/da
  Value slope_in_second;  ///< df/db; null for functions of one argument
  Parity parity = Parity::none;
  /// A function of the arguments that changes its sign where f or its slope jumps; null if f is
  /// smooth.
  Value kink = nullptr;
};

/// All functions of the grammar. A new function needs one entry in this table.
inline constexpr std::array kFunctions{
    Function{"abs", 1, [](double a, double) { return std::abs(a); },
             [](double a, double) { return a < 0   ? -1.0
                                           : a > 0 ? 1.0
                                                   : 0.0; }, nullptr,
             Parity::even, [](double a, double) { return a; }},
    Function{"sign", 1, [](double a, double) { return a < 0   ? -1.0
                                                      : a > 0 ? 1.0
                                                              : 0.0; },
             [](double, double) { return 0.0; }, nullptr, Parity::odd,
             [](double a, double) { return a; }},
    // The comparisons with the argument itself propagate a value that is not a number.
    Function{"max", 2, [](double a, double b) { return a > b || a != a ? a : b; },
             [](double a, double b) { return a >= b ? 1.0 : 0.0; },
             [](double a, double b) { return a >= b ? 0.0 : 1.0; }, Parity::none,
             [](double a, double b) { return a - b; }},
    Function{"min", 2, [](double a, double b) { return a < b || a != a ? a : b; },
             [](double a, double b) { return a <= b ? 1.0 : 0.0; },
             [](double a, double b) { return a <= b ? 0.0 : 1.0; }, Parity::none,
             [](double a, double b) { return a - b; }},
    Function{"sqrt", 1, [](double a, double) { return std::sqrt(a); },
             [](double a, double) { return 0.5 / std::sqrt(a); }, nullptr},
    Function{"exp", 1, [](double a, double) { return std::exp(a); },
             [](double a, double) { return std::exp(a); }, nullptr},
    Function{"log", 1, [](double a, double) { return std::log(a); },
             [](double a, double) { return 1 / a; }, nullptr},
    Function{"sin", 1, [](double a, double) { return std::sin(a); },
             [](double a, double) { return std::cos(a); }, nullptr, Parity::odd},
    Function{"cos", 1, [](double a, double) { return std::cos(a); },
             [](double a, double) { return -std::sin(a); }, nullptr, Parity::even},
    Function{"tan", 1, [](double a, double) { return std::tan(a); },
             [](double a, double) { return 1 + std::tan(a) * std::tan(a); }, nullptr, Parity::odd},
    Function{"atan", 1, [](double a, double) { return std::atan(a); },
             [](double a, double) { return 1 / (1 + a * a); }, nullptr, Parity::odd},
    Function{"sinh", 1, [](double a, double) { return std::sinh(a); },
             [](double a, double) { return std::cosh(a); }, nullptr, Parity::odd},
    Function{"cosh", 1, [](double a, double) { return std::cosh(a); },
             [](double a, double) { return std::sinh(a); }, nullptr, Parity::even},
    Function{"tanh", 1, [](double a, double) { return std::tanh(a); },
             [](double a, double) { return 1 - std::tanh(a) * std::tanh(a); }, nullptr,
             Parity::odd},
    Function{"erf", 1, [](double a, double) { return std::erf(a); },
             [](double a, double) { return 2 * std::numbers::inv_sqrtpi * std::exp(-a * a); },
             nullptr, Parity::odd},
    Function{"erfc", 1, [](double a, double) { return std::erfc(a); },
             [](double a, double) { return -2 * std::numbers::inv_sqrtpi * std::exp(-a * a); },
             nullptr},
};

}  // namespace fpkcheck::problem
