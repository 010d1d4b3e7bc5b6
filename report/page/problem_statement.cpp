#include "report/page/problem_statement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::report {
namespace {

using problem::Problem;
using problem::SystemCoefficients;

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

// Typesets the formula of a force: v becomes y′, a product a centred dot, a constant exponent a
// superscript.
std::string formula_html(const std::string& formula) {
  std::string html;
  const auto is_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (std::size_t n = 0; n < formula.size(); ++n) {
    const char c = formula[n];
    const bool alone = (n == 0 || !is_word(formula[n - 1])) &&
                       (n + 1 == formula.size() || !is_word(formula[n + 1]));
    if (c == 'v' && alone) {
      html += "y′";
    } else if (c == '*') {
      html += "·";
    } else if (c == '-') {
      html += "−";
    } else if (c == '^' && n + 1 < formula.size() &&
               std::isdigit(static_cast<unsigned char>(formula[n + 1]))) {
      std::size_t end = n + 1;
      while (end < formula.size() &&
             (std::isdigit(static_cast<unsigned char>(formula[end])) || formula[end] == '.')) {
        ++end;
      }
      html += "<sup>" + formula.substr(n + 1, end - n - 1) + "</sup>";
      n = end - 1;
    } else {
      html += c;
    }
  }
  return html;
}

class ProblemStatement {
 public:
  explicit ProblemStatement(std::span<const Problem* const> problems) : problems_(problems) {}

  std::string html() const {
    const bool impulses = any([](const Problem& p) { return p.impulses.is_present(); });
    const bool noise = any([](const Problem& p) { return p.noise.is_present(); });
    std::vector<std::string> excitation;
    if (impulses) excitation.emplace_back("Σ<sub>k</sub> Y<sub>k</sub> δ(t − τ<sub>k</sub>)");
    if (noise) excitation.emplace_back("√(2D) W(t)");
    return fmt::format(
        "<p>An oscillator {}, {}:</p>\n<p class=\"formula\">y″{}{} = {}{}</p>\n<p>{}{}{}</p>\n",
        walls_in_words(), excitation_in_words(impulses, noise), damping(), force(),
        fmt::join(excitation, " + "), walls(), impulses ? kImpulses : "", noise ? kNoise : "",
        kUnknownText);
  }

 private:
  template <class Has>
  bool any(const Has& has) const {
    return std::ranges::any_of(problems_, [&](const Problem* p) { return has(*p); });
  }
  template <std::size_t N>
  std::vector<std::string> present(const EquationTerm (&terms)[N]) const {
    std::vector<std::string> symbols;
    for (const EquationTerm& term : terms) {
      if (any([&](const Problem& p) { return p.system.coefficients().*term.coefficient != 0; })) {
        symbols.emplace_back(term.symbol);
      }
    }
    return symbols;
  }
  // The formula, if all problems have the same one.
  std::optional<std::string> formula() const {
    const auto& first = problems_.front()->system.coefficients().force;
    const bool same = first && std::ranges::all_of(problems_, [&](const Problem* p) {
                        return p->system.coefficients().force == first;
                      });
    return same ? first : std::nullopt;
  }
  std::string damping() const {
    if (const auto text = formula()) return " + " + formula_html(*text);
    if (any([](const Problem& p) { return !p.system.has_polynomial_force(); }))
      return " + f(y, y′)";
    const auto terms = present(kDamping);
    if (terms.empty()) return "";
    if (terms.size() == 1) return fmt::format(" + {} y′", terms.front());
    return fmt::format(" + ({}) y′", fmt::join(terms, " + "));
  }
  std::string force() const {
    if (formula() || any([](const Problem& p) { return !p.system.has_polynomial_force(); })) {
      return "";
    }
    std::string text;
    for (const std::string& term : present(kForce)) text += " + " + term;
    return text;
  }
  bool left() const {
    return any([](const Problem& p) { return p.system.left_wall().has_value(); });
  }
  bool right() const {
    return any([](const Problem& p) { return p.system.right_wall().has_value(); });
  }
  // A problem without wall parameters has the single wall of the paper's oscillator, at y = 0 with
  // the restitution coefficient r.
  bool only_at_zero() const {
    return !right() && !any([](const Problem& p) { return !p.system.wall_parameters().empty(); });
  }
  std::string walls() const {
    if (only_at_zero()) {
      return " &nbsp; for y &gt; 0, &emsp; y′<sub>+</sub> = −r y′<sub>−</sub> &nbsp; at y = 0.";
    }
    std::vector<std::string> text;
    if (left()) text.emplace_back("y′<sub>+</sub> = −r<sub>a</sub> y′<sub>−</sub> &nbsp; at y = a");
    if (right())
      text.emplace_back("y′<sub>+</sub> = −r<sub>b</sub> y′<sub>−</sub> &nbsp; at y = b");
    if (text.empty()) return ".";
    const char* domain = !right()  ? " &nbsp; for y &gt; a"
                         : !left() ? " &nbsp; for y &lt; b"
                                   : " &nbsp; for a &lt; y &lt; b";
    return fmt::format("{}, &emsp; {}.", domain, fmt::join(text, ", &emsp; "));
  }
  std::string walls_in_words() const {
    if (left() && right()) return "between walls";
    return left() || right() ? "with a wall" : "without walls";
  }
  static std::string excitation_in_words(bool impulses, bool noise) {
    if (impulses && noise) return "under random impulses and white noise";
    return impulses ? "under random impulses" : "under white noise";
  }

  std::span<const Problem* const> problems_;
};

}  // namespace

std::string problem_statement(std::span<const Problem* const> problems) {
  const bool all_linearisable = std::ranges::all_of(
      problems, [](const Problem* p) { return problem::has_equivalent_linearisation(*p); });
  if (all_linearisable)
    return fmt::format("{}<p>{}{}</p>\n", kBaseClassStatement, kImpulses, kUnknownText);
  return ProblemStatement(problems).html();
}

}  // namespace fpkcheck::report
