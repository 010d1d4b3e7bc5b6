#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/dual_number.hpp"
#include "problem/expression/functions.hpp"

namespace fpkcheck::problem {

/// Values of the named constants that an expression may use.
using NamedConstants = std::map<std::string, double, std::less<>>;

/// Returns whether a name can denote a constant in formulas. A valid constant name consists of
/// letters, digits and '_', and is neither y, v, t or pi nor the name of a function.
bool is_valid_constant_name(std::string_view name);

/// Coefficients of a polynomial in y and v: the map from the exponents (i, j) to the coefficient of
/// y^i v^j.
using BivariateCoefficients = std::map<std::pair<int, int>, double>;

/// A formula of the displacement y and the velocity v, for example `0.1*v + y + mu*y^3`.
///
///     sum     = product {("+" | "-") product}
///     product = signed {("*" | "/") signed}
///     signed  = ["+" | "-"] signed | power
///     power   = atom ["^" signed]                       (a^b^c = a^(b^c), -a^2 = -(a^2))
///     atom    = number | name | function "(" sum {"," sum} ")" | "(" sum ")"
///
/// A name in a formula is y, v, pi or a named constant; kFunctions lists the functions. An
/// Expression stores the formula in postfix notation, with constant parts evaluated. Expressions
/// are immutable, so that several threads can evaluate the same expression.
class Expression {
 public:
  /// Parses the text of a formula.
  /// @param label beginning of error messages, for example the key of the case file
  /// @param variables letters of the admissible variables, such as "yv", "y", "v" or "t"
  /// @throws InputError "LABEL column N: CAUSE; ACTION" for a text outside the grammar, an unknown
  /// name, or a text above the limits of length, nesting and number of operations
  static Expression parse(std::string_view text, const NamedConstants& constants,
                          const std::string& label, std::string_view variables = "yv");

  const std::string& formula_text() const { return text_; }

  /// Returns the value of the expression. The template argument `Number` is double, DualNumber, or
  /// another aggregate whose first member is the value. The namespace of the type `Number` defines
  /// arithmetic, apply_named_function() and real_power().
  template <class Number>
  Number operator()(const Number& y, const Number& v) const {
    return evaluate<Number>(0, nodes_.size(), y, v);
  }
  /// Number of points that evaluate_batch() evaluates at once.
  static constexpr int kBatchPoints = 8;
  /// Computes the values of the expression at `count` <= kBatchPoints points (y, v), faster than by
  /// single evaluations. The values of the batch evaluation differ from the values of operator() by
  /// rounding errors, and do not depend on the other points of the batch.
  void evaluate_batch(std::size_t count, const double* y, const double* v, double* values) const;
  /// Computes the values of the expression, and the derivatives with respect to v, at `count` <=
  /// kBatchPoints points.
  void evaluate_batch_with_velocity_slopes(std::size_t count, const double* y, const double* v,
                                           double* values, double* slopes) const;
  /// @pre the derivative exists at (y, v)
  double derivative_in_y(double y, double v) const {
    return (*this)(numerics::DualNumber{y, 1}, numerics::DualNumber{v, 0}).derivative;
  }
  /// @pre the derivative exists at (y, v)
  double derivative_in_v(double y, double v) const {
    return (*this)(numerics::DualNumber{y, 0}, numerics::DualNumber{v, 1}).derivative;
  }

  bool depends_on_y() const { return depends_on_variable(Operation::y); }
  bool depends_on_v() const { return depends_on_variable(Operation::v); }

  /// Returns the coefficients of an expression that is a polynomial in y and v; nullopt if the
  /// expression is no polynomial.
  std::optional<BivariateCoefficients> polynomial_coefficients() const;
  /// Returns the parity of the expression under (y, v) -> (-y, -v), as far as the parity follows
  /// from the parities of the terms and factors. The returned parity is FunctionParity::none if the
  /// parity follows only from an algebraic identity.
  FunctionParity parity() const;
  /// Returns the values of y in (low, high) at which the expression or its slope jumps for every v,
  /// in increasing order.
  std::vector<double> kinks_in_y(double low, double high) const;
  /// Returns the values of v in (low, high) at which the expression or its slope jumps for every y,
  /// in increasing order.
  std::vector<double> kinks_in_v(double low, double high) const;
  /// Returns whether the expression or its slope jumps along a curve other than y = const. and v =
  /// const. An example of such an expression is abs(y - v).
  bool has_kinks_along_other_curves() const;
  /// Returns whether the expression contains a function with a kink, for example abs(), or a
  /// non-integer power.
  bool has_kinks() const;
  /// Returns whether the expression contains sign(), and therefore jumps.
  bool has_jumps() const;
  /// Returns whether the expression contains sign() of a function of v, and therefore jumps in v.
  bool has_jumps_in_v() const;
  /// Returns whether the expression jumps in v at a velocity 0 < |v| < `v_limit`.
  bool has_jumps_at_nonzero_v(double v_limit) const;

  /// Largest accepted numbers of characters, operations and nested operations of a formula.
  static constexpr std::size_t kMaxLength = 4000, kMaxNodes = 2000, kMaxDepth = 100;

 private:
  enum class Operation { constant, y, v, add, subtract, multiply, divide, negate, power, call };
  struct Node {
    Operation operation;
    double constant = 0;                      // value of a constant; integer exponent of `power`
    bool has_integer_exponent = false;        // the exponent is `constant`, not an operand
    const NamedFunction* function = nullptr;  // function of a call
    std::size_t first = 0;  // index of the first node of this operation's operands
  };
  friend class ExpressionParser;

  template <class Number>
  static Number integer_power(const Number& base, int exponent);
  // Evaluates the nodes begin .. end - 1 of the expression. Before the call of a function of the
  // formula, evaluation calls on_call(k, a, b) with the index k of the node and the arguments a and
  // b; b equals a for functions of one argument.
  struct IgnoreCalls {
    template <class Number>
    void operator()(std::size_t, const Number&, const Number&) const {}
  };
  template <class Number, class OnCall = IgnoreCalls>
  Number evaluate(std::size_t begin, std::size_t end, const Number& y, const Number& v,
                  const OnCall& on_call = {}) const;
  template <class Number>
  Number evaluate_simd_batch(const Number& y, const Number& v, std::size_t count) const;
  bool depends_on_variable(Operation variable) const;
  bool contains_operation(std::size_t begin, std::size_t end, Operation operation) const;
  bool expression_node_jumps_in_v(std::size_t node) const;
  // Returns the values of a variable at which the function of a node with wanted(node) has a kink.
  std::vector<double> find_kinks(Operation variable, double low, double high,
                                 const std::function<bool(std::size_t)>& wanted) const;

  std::string text_;
  std::vector<Node> nodes_;  // postfix order
};

/// Returns the value of a named function of one or two numbers.
inline double apply_named_function(const NamedFunction& f, double a, double b) {
  return f.value(a, b);
}
inline numerics::DualNumber apply_named_function(const NamedFunction& f,
                                                 const numerics::DualNumber& a,
                                                 const numerics::DualNumber& b) {
  const double in_first = a.derivative == 0 ? 0 : f.slope(a.value, b.value) * a.derivative;
  const double in_second = f.arguments == 1 || b.derivative == 0
                               ? 0
                               : f.slope_in_second(a.value, b.value) * b.derivative;
  return {f.value(a.value, b.value), in_first + in_second};
}
inline double real_power(double a, double b) { return std::pow(a, b); }
inline numerics::DualNumber real_power(const numerics::DualNumber& a,
                                       const numerics::DualNumber& b) {
  const double value = std::pow(a.value, b.value);
  double slope = a.derivative == 0 ? 0 : b.value * std::pow(a.value, b.value - 1) * a.derivative;
  if (b.derivative != 0) slope += value * std::log(a.value) * b.derivative;
  return {value, slope};
}
template <class Number>
Number Expression::integer_power(const Number& base, int exponent) {
  Number power = base;
  Number result = base - base;
  bool started = false;
  for (int n = exponent < 0 ? -exponent : exponent; n > 0; n >>= 1, power = power * power) {
    if ((n & 1) == 0) continue;
    result = started ? result * power : power;
    started = true;
  }
  return result;
}

template <class Number, class OnCall>
Number Expression::evaluate(std::size_t begin, std::size_t end, const Number& y, const Number& v,
                            const OnCall& on_call) const {
  std::array<Number, kMaxDepth + 1> stack;
  std::size_t top = 0;  // number of values on the stack
  for (std::size_t k = begin; k < end; ++k) {
    const Node& node = nodes_[k];
    switch (node.operation) {
      case Operation::constant:
        stack[top++] = Number{node.constant};
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
      case Operation::power:
        if (node.has_integer_exponent) {
          const int exponent = static_cast<int>(node.constant);
          const Number power = integer_power(stack[top - 1], exponent);
          stack[top - 1] = exponent < 0 ? Number{1} / power : power;
        } else {
          --top;
          stack[top - 1] = real_power(stack[top - 1], stack[top]);
        }
        break;
      case Operation::call: {
        if (node.function->arguments == 2) --top;
        const Number& second = stack[node.function->arguments == 2 ? top : top - 1];
        on_call(k, stack[top - 1], second);
        stack[top - 1] = apply_named_function(*node.function, stack[top - 1], second);
        break;
      }
    }
  }
  return stack[0];
}

}  // namespace fpkcheck::problem
