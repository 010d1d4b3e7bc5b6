#include "report/page/page_sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "problem/equivalent_linearisation.hpp"
#include "report/page/html_elements.hpp"

namespace fpkcheck::report {
namespace {

using problem::Problem;
using problem::SystemCoefficients;
using problem::Wall;
using problem::Walls;

constexpr const char* kBaseClassStatement =
    R"html(<p>A particle on a hardening spring bounces off a wall at its equilibrium position and is driven by random
impulses:</p>
<p class="formula">y″ + c y′ + k y + μ y³ = Σ<sub>k</sub> Y<sub>k</sub> δ(t − τ<sub>k</sub>) &nbsp; for y &gt; 0,
&emsp; y′<sub>+</sub> = −r y′<sub>−</sub> &nbsp; at y = 0.</p>
)html";
constexpr const char* kImpulses =
    "The impulses arrive as a Poisson process of rate λ; their amplitudes Y are independent and "
    "follow one law. ";
constexpr const char* kNoise = "W is Gaussian white noise of unit intensity. ";
constexpr const char* kUnknownText =
    "The unknown is the\nstationary probability density p(y, y′) of displacement and velocity, "
    "with the marginal densities p(y) and p(y′). All quantities are\nnon-dimensional.";

struct EquationTerm {
  double SystemCoefficients::*coefficient;
  const char* symbol;
};
constexpr EquationTerm kDamping[] = {{&SystemCoefficients::damping, "c"},
                                     {&SystemCoefficients::van_der_pol, "c<sub>yy</sub> y²"},
                                     {&SystemCoefficients::rayleigh, "c<sub>vv</sub> y′²"}};
constexpr EquationTerm kForce[] = {{&SystemCoefficients::constant, "g₀"},
                                   {&SystemCoefficients::stiffness, "k y"},
                                   {&SystemCoefficients::quadratic, "k₂ y²"},
                                   {&SystemCoefficients::cubic, "μ y³"},
                                   {&SystemCoefficients::quintic, "k₅ y⁵"}};

/// Typesets a formula of a case file: v becomes y′ or u, a product a centred dot, an exponent a
/// superscript, abs(..) bars, sqrt(..) a root.
class FormulaTypesetter {
 public:
  FormulaTypesetter(const std::string& formula, const char* velocity)
      : text_(formula), velocity_(velocity) {}

  std::string html() { return html_until(text_.size()); }

 private:
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
  static bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
  }
  bool at_opening_parenthesis() const { return at_ < text_.size() && text_[at_] == '('; }
  std::string take_word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_word(text_[at_])) {
      ++at_;
      // The sign of a decimal exponent, as in 1e-3, belongs to the number.
      const bool is_exponent = is_digit(text_[begin]) && std::tolower(text_[at_ - 1]) == 'e';
      if (is_exponent && at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }
  // Typesets the text within the parentheses that open at the current position, without the
  // parentheses.
  std::string take_parenthesised() {
    std::size_t end = ++at_;
    for (int depth = 1; end < text_.size(); ++end) {
      if (text_[end] == '(') ++depth;
      if (text_[end] == ')' && --depth == 0) break;
    }
    std::string inside = html_until(end);
    at_ = std::min(end + 1, text_.size());
    return inside;
  }
  std::string take_exponent() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_opening_parenthesis()) return take_parenthesised();
    std::string exponent;
    for (; at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+'); ++at_) {
      exponent += text_[at_] == '-' ? "−" : "+";
    }
    exponent += take_word_html();
    if (at_ < text_.size() && text_[at_] == '^') {
      ++at_;
      exponent += "<sup>" + take_exponent() + "</sup>";
    }
    return exponent;
  }
  std::string take_word_html() {
    const std::string word = take_word();
    if (at_opening_parenthesis()) {
      const std::string argument = take_parenthesised();
      if (word == "abs") return "|" + argument + "|";
      if (word == "sqrt") return "√(" + argument + ")";
      return word + "(" + argument + ")";
    }
    return word == "v" ? velocity_ : word == "pi" ? "π" : word;
  }
  std::string html_until(std::size_t end) {
    std::string html;
    while (at_ < end) {
      const char c = text_[at_];
      if (is_word(c)) {
        html += take_word_html();
      } else if (c == '^') {
        ++at_;
        html += "<sup>" + take_exponent() + "</sup>";
      } else {
        ++at_;
        html += c == '*' ? "·" : c == '-' ? "−" : escape_html(std::string(1, c));
      }
    }
    return html;
  }

  const std::string& text_;
  const std::string velocity_;
  std::size_t at_ = 0;
};

std::string formula_html(const std::string& formula, const char* velocity = "y′") {
  return FormulaTypesetter(formula, velocity).html();
}

class EquationOfMotionHtml {
 public:
  explicit EquationOfMotionHtml(std::span<const Problem* const> problems) : problems_(problems) {}

  std::string html() const {
    const bool impulses = any_problem_has([](const Problem& p) { return p.impulses.is_acting(); });
    const bool noise = any_problem_has([](const Problem& p) { return p.noise.is_acting(); });
    std::vector<std::string> excitation;
    const bool parametric =
        any_problem_has([](const Problem& p) { return p.impulse_factor.has_value(); });
    if (impulses) {
      excitation.push_back(fmt::format("{}Σ<sub>k</sub> Y<sub>k</sub> δ(t − τ<sub>k</sub>)",
                                       parametric ? "b(y) " : ""));
    }
    const bool factor =
        any_problem_has([](const Problem& p) { return p.noise_factor.has_value(); });
    if (noise) excitation.emplace_back(factor ? "√(2D) g(y, y′) W(t)" : "√(2D) W(t)");
    return fmt::format(
        "<p>An oscillator {}, {}:</p>\n<p class=\"formula\">y″{}{} = {}{}</p>\n{}<p>{}{}{}</p>\n",
        walls_in_words(), excitation_in_words(impulses, noise), damping_terms_html(),
        force_terms_html(), fmt::join(excitation, " + "), wall_conditions_html(),
        factor_and_restitution_html(), impulses ? kImpulses : "", noise ? kNoise : "",
        kUnknownText);
  }

 private:
  template <class Has>
  bool any_problem_has(const Has& has) const {
    return std::ranges::any_of(problems_, [&](const Problem* p) { return has(*p); });
  }
  template <std::size_t N>
  std::vector<std::string> present_term_symbols(const EquationTerm (&terms)[N]) const {
    std::vector<std::string> symbols;
    for (const EquationTerm& term : terms) {
      if (any_problem_has(
              [&](const Problem& p) { return p.system.coefficients().*term.coefficient != 0; })) {
        symbols.emplace_back(term.symbol);
      }
    }
    return symbols;
  }
  // Returns the text of a formula if all problems have the same formula; otherwise an empty result.
  template <class Text>
  std::optional<std::string> common_formula_text(const Text& text) const {
    const std::optional<std::string> first = text(*problems_.front());
    const bool same = first && std::ranges::all_of(
                                   problems_, [&](const Problem* p) { return text(*p) == first; });
    return same ? first : std::nullopt;
  }
  std::optional<std::string> common_force_formula() const {
    return common_formula_text([](const Problem& p) { return p.system.coefficients().force; });
  }
  bool has_restitution_formula(std::optional<Wall> Walls::*side) const {
    return any_problem_has([&](const Problem& p) {
      const auto& wall = p.system.walls().*side;
      return wall && !wall->has_constant_restitution();
    });
  }
  std::string impact_condition_html(std::optional<Wall> Walls::*side, const char* position) const {
    return fmt::format("y′<sub>+</sub> = −r<sub>{0}</sub>{1} y′<sub>−</sub> &nbsp; at y = {0}",
                       position, has_restitution_formula(side) ? "(u)" : "");
  }
  // Returns the formulas of the noise factor, the impulse factor and the restitution coefficients,
  // one formula in each line.
  std::string factor_and_restitution_html() const {
    std::string html;
    const auto add = [&](const std::string& definition) {
      html += fmt::format("<p class=\"formula\">{}</p>\n", definition);
    };
    if (const auto factor = common_formula_text(
            [](const Problem& p) { return p.impulses.impulse_parameters().factor; })) {
      add(fmt::format("b(y) = {}", formula_html(*factor)));
    }
    if (const auto factor = common_formula_text([](const Problem& p) { return p.noise.factor; })) {
      const auto sense = common_formula_text([](const Problem& p) -> std::optional<std::string> {
        if (!p.noise.interpretation) return std::nullopt;
        return *p.noise.interpretation == problem::NoiseInterpretation::ito ? "Itô"
                                                                            : "Stratonovich";
      });
      add(fmt::format("g(y, y′) = {}{}", formula_html(*factor),
                      sense ? fmt::format(" &emsp; (in the sense of {})", *sense) : ""));
    }
    const auto add_restitution = [&](std::optional<Wall> Walls::*side, const char* subscript) {
      const auto restitution =
          common_formula_text([&](const Problem& p) -> std::optional<std::string> {
            const auto& wall = p.system.walls().*side;
            if (!wall || wall->has_constant_restitution()) return std::nullopt;
            return wall->restitution_formula->formula_text();
          });
      if (!restitution) return;
      add(fmt::format("r<sub>{}</sub>(u) = {} &emsp; with the impact speed u = |y′<sub>−</sub>|",
                      subscript, formula_html(*restitution, "u")));
    };
    add_restitution(&Walls::left, "a");
    add_restitution(&Walls::right, "b");
    return html;
  }
  std::string damping_terms_html() const {
    if (const auto text = common_force_formula()) return " + " + formula_html(*text);
    if (any_problem_has([](const Problem& p) { return !p.system.has_polynomial_force(); }))
      return " + f(y, y′)";
    const auto terms = present_term_symbols(kDamping);
    if (terms.empty()) return "";
    if (terms.size() == 1) return fmt::format(" + {} y′", terms.front());
    return fmt::format(" + ({}) y′", fmt::join(terms, " + "));
  }
  std::string force_terms_html() const {
    if (common_force_formula() ||
        any_problem_has([](const Problem& p) { return !p.system.has_polynomial_force(); })) {
      return "";
    }
    std::string text;
    for (const std::string& term : present_term_symbols(kForce)) text += " + " + term;
    return text;
  }
  bool has_left_wall() const {
    return any_problem_has([](const Problem& p) { return p.system.left_wall().has_value(); });
  }
  bool has_right_wall() const {
    return any_problem_has([](const Problem& p) { return p.system.right_wall().has_value(); });
  }
  // A problem without wall parameters has the single wall of the paper's oscillator, at y = 0 with
  // the restitution coefficient r.
  bool has_only_wall_at_zero() const {
    return !has_right_wall() && !any_problem_has([](const Problem& p) {
      return !p.system.wall_parameters().is_section_absent();
    });
  }
  std::string wall_conditions_html() const {
    if (has_only_wall_at_zero()) {
      return " &nbsp; for y &gt; 0, &emsp; y′<sub>+</sub> = −r y′<sub>−</sub> &nbsp; at y = 0.";
    }
    std::vector<std::string> text;
    if (has_left_wall()) text.push_back(impact_condition_html(&Walls::left, "a"));
    if (has_right_wall()) text.push_back(impact_condition_html(&Walls::right, "b"));
    if (text.empty()) return ".";
    const char* domain = !has_right_wall()  ? " &nbsp; for y &gt; a"
                         : !has_left_wall() ? " &nbsp; for y &lt; b"
                                            : " &nbsp; for a &lt; y &lt; b";
    return fmt::format("{}, &emsp; {}.", domain, fmt::join(text, ", &emsp; "));
  }
  std::string walls_in_words() const {
    if (has_left_wall() && has_right_wall()) return "between walls";
    return has_left_wall() || has_right_wall() ? "with a wall" : "without walls";
  }
  static std::string excitation_in_words(bool impulses, bool noise) {
    if (impulses && noise) return "under random impulses and white noise";
    return impulses ? "under random impulses" : "under white noise";
  }

  std::span<const Problem* const> problems_;
};

}  // namespace

std::string problem_statement(std::span<const Problem* const> problems) {
  const bool has_base_class_equation = std::ranges::all_of(problems, [](const Problem* p) {
    return problem::has_equivalent_linearisation(*p) && !p->system.coefficients().force;
  });
  if (has_base_class_equation)
    return fmt::format("{}<p>{}{}</p>\n", kBaseClassStatement, kImpulses, kUnknownText);
  return EquationOfMotionHtml(problems).html();
}

}  // namespace fpkcheck::report
