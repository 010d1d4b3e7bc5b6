#include "problem/expression/expression.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::problem {
namespace {

// A polynomial in y and v, or nothing for an expression that is not a polynomial.
using Polynomial = std::optional<BivariateCoefficients>;

// The limit of the polynomial degree bounds the time of the expansion of an expression, which grows
// with the fourth power of the degree.
constexpr int kMaxPolynomialDegree = 12;

// Returns the polynomial a + factor b of two polynomials a and b.
Polynomial add_scaled_polynomial(const Polynomial& a, const Polynomial& b, double factor) {
  if (!a || !b) return std::nullopt;
  Polynomial result = a;
  for (const auto& [exponents, coefficient] : *b) (*result)[exponents] += factor * coefficient;
  return result;
}

Polynomial multiply_polynomials(const Polynomial& a, const Polynomial& b) {
  if (!a || !b) return std::nullopt;
  BivariateCoefficients result;
  for (const auto& [m, x] : *a) {
    for (const auto& [n, y] : *b) {
      const std::pair exponents{m.first + n.first, m.second + n.second};
      if (exponents.first + exponents.second > kMaxPolynomialDegree) return std::nullopt;
      result[exponents] += x * y;
    }
  }
  return result;
}

// Returns the value of a polynomial that depends on neither y nor v; nullopt for other polynomials.
std::optional<double> constant_of_polynomial(const Polynomial& a) {
  if (!a) return std::nullopt;
  double value = 0;
  for (const auto& [exponents, coefficient] : *a) {
    if (exponents == std::pair{0, 0}) {
      value = coefficient;
    } else if (coefficient != 0) {
      return std::nullopt;
    }
  }
  return value;
}

Polynomial monomial(int i, int j, double coefficient) {
  return BivariateCoefficients{{{i, j}, coefficient}};
}

FunctionParity parity_of_product(FunctionParity a, FunctionParity b) {
  if (a == FunctionParity::none || b == FunctionParity::none) return FunctionParity::none;
  return a == b ? FunctionParity::even : FunctionParity::odd;
}

}  // namespace

bool Expression::contains_operation(std::size_t begin, std::size_t end, Operation operation) const {
  return std::any_of(nodes_.begin() + static_cast<std::ptrdiff_t>(begin),
                     nodes_.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](const Node& node) { return node.operation == operation; });
}

bool Expression::depends_on_variable(Operation variable) const {
  return contains_operation(0, nodes_.size(), variable);
}

std::optional<BivariateCoefficients> Expression::polynomial_coefficients() const {
  std::vector<Polynomial> stack;
  const auto pop = [&] {
    Polynomial last = std::move(stack.back());
    stack.pop_back();
    return last;
  };
  for (const Node& node : nodes_) {
    switch (node.operation) {
      case Operation::constant:
        stack.push_back(monomial(0, 0, node.constant));
        break;
      case Operation::y:
        stack.push_back(monomial(1, 0, 1));
        break;
      case Operation::v:
        stack.push_back(monomial(0, 1, 1));
        break;
      case Operation::add:
      case Operation::subtract: {
        const Polynomial b = pop(), a = pop();
        stack.push_back(add_scaled_polynomial(a, b, node.operation == Operation::add ? 1 : -1));
        break;
      }
      case Operation::multiply: {
        const Polynomial b = pop(), a = pop();
        stack.push_back(multiply_polynomials(a, b));
        break;
      }
      case Operation::divide: {
        const Polynomial b = pop(), a = pop();
        const auto divisor = constant_of_polynomial(b);
        if (!a || !divisor) {
          stack.emplace_back();
          break;
        }
        Polynomial quotient = a;
        for (auto& entry : *quotient) entry.second /= *divisor;
        stack.push_back(quotient);
        break;
      }
      case Operation::negate:
        stack.push_back(multiply_polynomials(monomial(0, 0, -1), pop()));
        break;
      case Operation::power: {
        if (!node.has_integer_exponent) {
          pop();
          pop();
          stack.emplace_back();
          break;
        }
        const Polynomial base = pop();
        Polynomial power = monomial(0, 0, 1);
        for (int n = 0; n < node.constant && power; ++n) power = multiply_polynomials(power, base);
        stack.push_back(node.constant < 0 ? Polynomial() : power);
        break;
      }
      case Operation::call:
        for (int k = 0; k < node.function->arguments; ++k) pop();
        stack.emplace_back();
        break;
    }
  }
  Polynomial result = std::move(stack.front());
  if (result) std::erase_if(*result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

FunctionParity Expression::parity() const {
  std::vector<FunctionParity> stack;
  const auto pop = [&] {
    const FunctionParity last = stack.back();
    stack.pop_back();
    return last;
  };
  for (const Node& node : nodes_) {
    switch (node.operation) {
      case Operation::constant:
        stack.push_back(FunctionParity::even);
        break;
      case Operation::y:
      case Operation::v:
        stack.push_back(FunctionParity::odd);
        break;
      case Operation::add:
      case Operation::subtract: {
        const FunctionParity b = pop(), a = pop();
        stack.push_back(a == b ? a : FunctionParity::none);
        break;
      }
      case Operation::multiply:
      case Operation::divide: {
        const FunctionParity b = pop(), a = pop();
        stack.push_back(parity_of_product(a, b));
        break;
      }
      case Operation::negate:
        break;
      case Operation::power: {
        const bool is_odd_power =
            node.has_integer_exponent && static_cast<int>(node.constant) % 2 != 0;
        const FunctionParity exponent = node.has_integer_exponent ? FunctionParity::even : pop();
        const FunctionParity base = pop();
        if (node.has_integer_exponent) {
          stack.push_back(base == FunctionParity::odd && !is_odd_power ? FunctionParity::even
                                                                       : base);
        } else {
          const bool is_even = base == FunctionParity::even && exponent == FunctionParity::even;
          stack.push_back(is_even ? FunctionParity::even : FunctionParity::none);
        }
        break;
      }
      case Operation::call: {
        FunctionParity arguments = pop();
        if (node.function->arguments == 2 && pop() != arguments) arguments = FunctionParity::none;
        stack.push_back(arguments == FunctionParity::odd ? node.function->parity : arguments);
        break;
      }
    }
  }
  return stack.front();
}

std::vector<double> Expression::find_kinks(Operation variable, double low, double high,
                                           const std::function<bool(std::size_t)>& wanted) const {
  const Operation other = variable == Operation::y ? Operation::v : Operation::y;
  // Number of grid points between which the search for kinks of an expression looks for sign
  // changes. The search can miss kinks with a distance below the distance of neighbouring grid
  // points. The search for kinks ends after kPoints sign changes, since no grid resolves more
  // kinks.
  constexpr int kPoints = 4000;
  std::vector<char> has_kink(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    has_kink[k] = nodes_[k].operation == Operation::call && nodes_[k].function->kink != nullptr &&
                  !contains_operation(nodes_[k].first, k, other) && wanted(k);
  }
  if (std::ranges::count(has_kink, 1) == 0) return {};
  // One evaluation of the expression computes the functions whose sign changes are kinks, so that
  // the time is linear in the number of nodes.
  std::vector<double> earlier_values(nodes_.size()), left_values(nodes_.size());
  std::vector<double> right_values(nodes_.size());
  const auto evaluate_kinks = [&](std::size_t end, double x, std::vector<double>& values) {
    const double y = variable == Operation::y ? x : 0, v = variable == Operation::y ? 0 : x;
    evaluate<double>(nodes_[end - 1].first, end, y, v, [&](std::size_t k, double a, double b) {
      if (has_kink[k] != 0) values[k] = nodes_[k].function->kink(a, b);
    });
  };
  std::set<double> found;
  double left = low;
  evaluate_kinks(nodes_.size(), low, left_values);
  for (int n = 1, changes = 0; n <= kPoints; ++n) {
    const double right = low + (high - low) * n / kPoints;
    evaluate_kinks(nodes_.size(), right, right_values);
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      if (has_kink[k] == 0) continue;
      const double at_left = left_values[k], at_right = right_values[k];
      // A zero at a grid point of the search is a kink if both neighbouring values differ from
      // zero. The condition on the neighbouring values excludes a function that is zero over an
      // interval, such as max(y, 0) for y < 0.
      if (n > 1 && earlier_values[k] != 0 && at_left == 0 && at_right != 0) found.insert(left);
      if (!((at_left < 0 && at_right > 0) || (at_left > 0 && at_right < 0))) continue;
      if (++changes > kPoints) return {found.begin(), found.end()};
      std::vector<double> values(nodes_.size());
      // The interpolation in the search for a root needs finite function values.
      constexpr double kLargest = 1e100;
      const auto value = [&](double x) {
        evaluate_kinks(k + 1, x, values);
        return std::isnan(values[k]) ? kLargest : std::clamp(values[k], -kLargest, kLargest);
      };
      found.insert(numerics::bracketed_root(value, left, right));
    }
    left = right;
    std::swap(earlier_values, left_values);
    std::swap(left_values, right_values);
  }
  return {found.begin(), found.end()};
}

std::vector<double> Expression::kinks_in_y(double low, double high) const {
  return find_kinks(Operation::y, low, high, [](std::size_t) { return true; });
}
std::vector<double> Expression::kinks_in_v(double low, double high) const {
  return find_kinks(Operation::v, low, high, [](std::size_t) { return true; });
}

bool Expression::has_kinks_along_other_curves() const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (nodes_[k].operation != Operation::call || nodes_[k].function->kink == nullptr) continue;
    if (contains_operation(nodes_[k].first, k, Operation::y) &&
        contains_operation(nodes_[k].first, k, Operation::v)) {
      return true;
    }
  }
  return false;
}

bool Expression::has_kinks() const {
  return std::ranges::any_of(nodes_, [](const Node& node) {
    return node.operation == Operation::call
               ? node.function->kink != nullptr
               : node.operation == Operation::power && !node.has_integer_exponent;
  });
}

bool Expression::has_jumps() const {
  return std::ranges::any_of(nodes_, [](const Node& node) {
    return node.operation == Operation::call && node.function->name == "sign";
  });
}

bool Expression::expression_node_jumps_in_v(std::size_t node) const {
  return nodes_[node].operation == Operation::call && nodes_[node].function->name == "sign" &&
         contains_operation(nodes_[node].first, node, Operation::v);
}

bool Expression::has_jumps_in_v() const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (expression_node_jumps_in_v(k)) return true;
  }
  return false;
}

bool Expression::has_jumps_at_nonzero_v(double v_limit) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (expression_node_jumps_in_v(k) && contains_operation(nodes_[k].first, k, Operation::y))
      return true;
  }
  const auto jumps = find_kinks(Operation::v, -v_limit, v_limit,
                                [&](std::size_t node) { return expression_node_jumps_in_v(node); });
  return std::ranges::any_of(jumps, [](double v) { return v != 0; });
}

}  // namespace fpkcheck::problem
