#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <numbers>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "problem/expression/expression.hpp"

namespace fpkcheck::problem {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_valid_constant_name(std::string_view name) {
  if (name.empty() || !is_letter(name.front()) || name == "y" || name == "v" || name == "t" ||
      name == "pi") {
    return false;
  }
  return std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); }) &&
         std::ranges::find(kFunctions, name, &NamedFunction::name) == kFunctions.end();
}

/// Recursive-descent parser that appends the operations of a formula in postfix order.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, const NamedConstants& constants, const std::string& label,
                   std::string_view variables)
      : text_(text), constants_(constants), label_(label), variables_(variables) {}

  Expression parse() {
    if (text_.size() > Expression::kMaxLength) {
      throw InputError(fmt::format("{} has {} characters; the limit is {}: shorten the formula",
                                   label_, text_.size(), Expression::kMaxLength));
    }
    result_.text_ = std::string(text_);
    parse_sum();
    if (at_ < text_.size()) fail("an operator or the end of the formula");
    return std::move(result_);
  }

 private:
  using Operation = Expression::Operation;
  using Node = Expression::Node;

  // Increases the nesting depth of the grammar's rules during the life of the Nesting object.
  struct Nesting {
    explicit Nesting(ExpressionParser& owner) : parser(owner) {
      if (++parser.depth_ > Expression::kMaxDepth) parser.fail_nested();
    }
    ~Nesting() { --parser.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    ExpressionParser& parser;
  };

  [[noreturn]] void fail_at(std::size_t at, const std::string& what) const {
    throw InputError(fmt::format("{} column {}: {}", label_, at + 1, what));
  }
  [[noreturn]] void fail(const std::string& expected) {
    skip_spaces();
    const char next = at_ < text_.size() ? text_[at_] : ' ';
    const bool begins_factor = next == '(' || is_letter(next) || is_digit(next);
    const std::string_view hint = next == '\''  ? "; write v for the velocity y'"
                                  : next == '|' ? "; write abs(v) for |v|"
                                  : next == '=' ? "; write only the force f of y'' + f = excitation"
                                  : next == '*' ? "; write y^2 for a power"
                                  : begins_factor ? "; write * between factors, as in 2*y*(1 + v)"
                                                  : "";
    // In an error message, a character that consists of several bytes (UTF-8) is quoted as a whole.
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    const std::string found = at_ >= text_.size()
                                  ? "the end of the formula"
                                  : base::in_quotes(std::string(text_.substr(at_, end - at_)));
    fail_at(std::min(at_, text_.size()),
            fmt::format("expected {}; found {}{}", expected, found, hint));
  }

  [[noreturn]] void fail_nested() const {
    fail_at(at_, fmt::format("more than {} nested operations; simplify the formula",
                             Expression::kMaxDepth));
  }

  void skip_spaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool accept(char symbol) {
    skip_spaces();
    if (at_ >= text_.size() || text_[at_] != symbol) return false;
    ++at_;
    return true;
  }

  // Appends an operation whose operands begin at the node `first`; an operation on constants is
  // evaluated immediately.
  void append(Node node, std::size_t first) {
    auto& nodes = result_.nodes_;
    if (nodes.size() >= Expression::kMaxNodes) {
      fail_at(at_,
              fmt::format("more than {} operations; simplify the formula", Expression::kMaxNodes));
    }
    const bool is_operand = node.operation == Operation::constant ||
                            node.operation == Operation::y || node.operation == Operation::v;
    node.first = is_operand ? nodes.size() : first;
    nodes.push_back(node);
    if (is_operand) {
      if (++stack_size_ > Expression::kMaxDepth) fail_nested();
      return;
    }
    const bool is_unary = node.operation == Operation::negate || node.has_integer_exponent ||
                          (node.function != nullptr && node.function->arguments == 1);
    if (!is_unary) --stack_size_;
    for (std::size_t k = first; k + 1 < nodes.size(); ++k) {
      if (nodes[k].operation != Operation::constant) return;
    }
    const double value = result_.evaluate<double>(first, nodes.size(), 0, 0);
    if (!std::isfinite(value)) fail_at(at_, "the value of the constants before is not finite");
    nodes.resize(first);
    --stack_size_;
    append_constant(value);
  }
  void append_constant(double value) { append(Node{Operation::constant, value}, 0); }

  void parse_sum() {
    const Nesting nesting(*this);
    const std::size_t first = result_.nodes_.size();
    parse_product();
    for (;;) {
      if (accept('+')) {
        parse_product();
        append(Node{Operation::add}, first);
      } else if (accept('-')) {
        parse_product();
        append(Node{Operation::subtract}, first);
      } else {
        return;
      }
    }
  }

  void parse_product() {
    const std::size_t first = result_.nodes_.size();
    parse_signed();
    for (;;) {
      if (accept('*')) {
        parse_signed();
        append(Node{Operation::multiply}, first);
      } else if (accept('/')) {
        const std::size_t divisor = result_.nodes_.size();
        parse_signed();
        const auto& nodes = result_.nodes_;
        if (nodes.size() == divisor + 1 && nodes[divisor].operation == Operation::constant &&
            nodes[divisor].constant == 0) {
          fail_at(at_, "division by zero; correct the divisor");
        }
        append(Node{Operation::divide}, first);
      } else {
        return;
      }
    }
  }

  void parse_signed() {
    const Nesting nesting(*this);
    const std::size_t first = result_.nodes_.size();
    if (accept('-')) {
      parse_signed();
      append(Node{Operation::negate}, first);
    } else if (accept('+')) {
      parse_signed();
    } else {
      parse_power();
    }
  }

  void parse_power() {
    auto& nodes = result_.nodes_;
    const std::size_t first = nodes.size();
    parse_atom();
    if (!accept('^')) return;
    const std::size_t exponent = nodes.size();
    parse_signed();
    // Powers with integer exponents are computed as products, which are exact for polynomials and
    // defined for a negative base.
    constexpr double kMaxIntegerExponent = 64;
    Node node{Operation::power};
    const bool is_constant =
        nodes.size() == exponent + 1 && nodes[exponent].operation == Operation::constant;
    const double value = nodes[exponent].constant;
    if (is_constant && value == 0) {
      nodes.resize(first);
      stack_size_ -= 2;
      append_constant(1);
      return;
    }
    if (is_constant && value == std::round(value) && std::abs(value) <= kMaxIntegerExponent) {
      nodes.resize(exponent);
      --stack_size_;
      node.has_integer_exponent = true;
      node.constant = value;
    }
    append(node, first);
  }

  void parse_atom() {
    skip_spaces();
    if (accept('(')) {
      parse_sum();
      if (!accept(')')) fail("')'");
    } else if (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) {
      parse_number();
    } else if (at_ < text_.size() && is_letter(text_[at_])) {
      parse_name();
    } else {
      fail("a number, a name or '('");
    }
  }

  void parse_number() {
    double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail_at(at_, "the number is out of range");
    if (error != std::errc()) fail("a number, a name or '('");
    at_ += static_cast<std::size_t>(end - begin);
    append_constant(value);
    if (at_ < text_.size() && (is_letter(text_[at_]) || text_[at_] == '.')) {
      fail("an operator after the number, as in 2*y");
    }
  }

  // Returns the variable, named constant or pi with a given name; nullopt for other names.
  std::optional<Node> operand_of(std::string_view name) const {
    if (name.size() == 1 && variables_.find(name) != std::string_view::npos) {
      return Node{name == "v" ? Operation::v : Operation::y};  // t is the first argument, as y is
    }
    const auto constant = constants_.find(name);
    if (constant != constants_.end()) return Node{Operation::constant, constant->second};
    if (name == "pi") return Node{Operation::constant, std::numbers::pi};
    return std::nullopt;
  }

  void parse_name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    if (accept('(')) {
      parse_call(name, begin);
    } else if (const auto operand = operand_of(name)) {
      append(*operand, 0);
    } else if (std::ranges::find(kFunctions, name, &NamedFunction::name) != kFunctions.end()) {
      fail_at(begin, fmt::format("the function {0} lacks its argument; write {0}(..)", name));
    } else {
      std::vector<std::string> known;
      for (const char variable : variables_) known.emplace_back(1, variable);
      for (const auto& [constant_name, value] : constants_) known.push_back(constant_name);
      known.emplace_back("pi");
      fail_at(begin, fmt::format("unknown name {}; known names: {}; add others to [parameters]",
                                 base::in_quotes(std::string(name)), fmt::join(known, ", ")));
    }
  }

  void parse_call(std::string_view name, std::size_t begin) {
    const auto function = std::ranges::find(kFunctions, name, &NamedFunction::name);
    if (function == kFunctions.end()) {
      if (operand_of(name))
        fail_at(begin, fmt::format("{0} is not a function; write {0}*(..)", name));
      std::vector<std::string_view> names;
      for (const NamedFunction& known : kFunctions) names.push_back(known.name);
      fail_at(begin, fmt::format("unknown function {}; known functions: {}",
                                 base::in_quotes(std::string(name)), fmt::join(names, ", ")));
    }
    const std::size_t first = result_.nodes_.size();
    parse_sum();
    for (int k = 1; k < function->arguments; ++k) {
      if (!accept(',')) fail(fmt::format("',' ({} has {} arguments)", name, function->arguments));
      parse_sum();
    }
    if (!accept(')')) {
      fail(fmt::format("')' ({} has {} argument{})", name, function->arguments,
                       function->arguments == 1 ? "" : "s"));
    }
    Node node{Operation::call};
    node.function = &*function;
    append(node, first);
  }

  std::string_view text_;
  const NamedConstants& constants_;
  const std::string& label_;
  std::string_view variables_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;       // nesting of the grammar's rules, which bounds the recursion
  std::size_t stack_size_ = 0;  // number of values on the stack after the last operation
  Expression result_;
};

Expression Expression::parse(std::string_view text, const NamedConstants& constants,
                             const std::string& label, std::string_view variables) {
  return ExpressionParser(text, constants, label, variables).parse();
}

}  // namespace fpkcheck::problem
