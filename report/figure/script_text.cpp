#include "report/figure/script_text.hpp"

#include <fmt/format.h>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "report/figure/gnuplot.hpp"

namespace fpkcheck::report {
namespace {

constexpr std::pair<std::string_view, std::string_view> kLatexSymbols[] = {
    {"−", "$-$"},       {"×", "$\\times$"}, {"λ", "$\\lambda$"}, {"μ", "$\\mu$"},
    {"σ", "$\\sigma$"}, {"Δ", "$\\Delta$"}, {"≤", "$\\le$"},     {"²", "$^2$"},
    {"′", "$'$"},       {"|", "$|$"},       {"<", "$<$"},        {">", "$>$"},
    {"#", "\\#"},       {"$", "\\$"},       {"%", "\\%"},        {"&", "\\&"},
    {"~", "\\~{}"},     {"--", "-{}-"},
};
// LaTeX code for the character after a backslash in gnuplot's enhanced text.
constexpr std::pair<char, std::string_view> kLatexEscapes[] = {
    {'_', "\\_"}, {'^', "\\^{}"}, {'{', "\\{"},   {'}', "\\}"},
    {'@', "@"},   {'&', "\\&"},   {'~', "\\~{}"}, {'\\', "\\textbackslash{}"},
};

std::string_view latex_escape(char c) {
  for (const auto& [letter, latex] : kLatexEscapes) {
    if (letter == c) return latex;
  }
  return "";
}

// Returns the text within the braces at a position of an enhanced text, or the letter at the
// position if there are no braces. The function take_argument() advances the position behind the
// returned text.
std::string_view take_argument(std::string_view text, std::size_t& position) {
  const bool in_braces = position < text.size() && text[position] == '{';
  const auto from = in_braces ? position + 1 : position;
  const auto to = in_braces ? std::min(text.find('}', from), text.size()) : from + 1;
  position = in_braces ? to + 1 : to;
  return from < text.size() ? text.substr(from, to - from) : "";
}

}  // namespace

std::string panel_position_commands(const FigurePanelBox& place) {
  return fmt::format(
      "set lmargin at screen {:.4g}\nset rmargin at screen {:.4g}\n"
      "set tmargin at screen {:.4g}\nset bmargin at screen {:.4g}\n",
      place.left, place.right, place.top, place.bottom);
}

std::string gnuplot_data_block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << EOD\n{}EOD\n", name, rows);
}

double choose_tick_step(double from, double to, int max_steps) {
  const double least = (to - from) / max_steps;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= least) return digit * power;
  }
  return 10 * power;
}

std::string density_in_enhanced_text(transform::StateVariable variable) {
  return variable == transform::StateVariable::y ? "{/:Italic p}({/:Italic y})"
                                                 : "{/:Italic p}({/:Italic y}')";
}

GnuplotPointTypes gnuplot_point_types(const std::string& symbol) {
  constexpr std::string_view kOpen = "-open";
  if (symbol.ends_with(kOpen)) {
    const int open = gnuplot_point_types(symbol.substr(0, symbol.size() - kOpen.size())).open;
    return {open, open};
  }
  constexpr std::pair<std::string_view, GnuplotPointTypes> kShapes[] = {
      {"cross", {1, 1}},           {"x", {2, 2}},         {"asterisk", {3, 3}},
      {"circle", {7, 6}},          {"square", {5, 4}},    {"triangle-up", {9, 8}},
      {"triangle-down", {11, 10}}, {"diamond", {13, 12}}, {"pentagon", {15, 14}}};
  for (const auto& [shape, types] : kShapes) {
    if (shape == symbol) return types;
  }
  constexpr int kCross = 2, kPlus = 1;
  return {kCross, kPlus};
}

int gnuplot_fill_pattern(const std::string& hatch) {
  constexpr std::pair<std::string_view, int> kPatterns[] = {
      {"x", 1}, {".", 2}, {"/", 4}, {"\\", 5}, {"|", 6}};
  for (const auto& [name, pattern] : kPatterns) {
    if (name == hatch) return pattern;
  }
  return 3;  // pattern of a solid fill
}

std::string valid_dash_type(const std::string& dash) {
  const bool lengths = dash.find_first_not_of("(),.0123456789") == std::string::npos;
  return lengths && !dash.empty() ? dash : "solid";
}

std::string replace_hyphens_by_minus_signs(std::string number) {
  boost::algorithm::replace_all(number, "-", kMinus);
  return number;
}

std::string scientific_notation_text(double value) {
  if (value == 0) return "0";
  const std::string text = fmt::format("{:+.1e}", value);
  const auto e = text.find('e');
  return replace_hyphens_by_minus_signs(
      fmt::format("{} × 10^{{{}}}", text.substr(0, e), std::stoi(text.substr(e + 1))));
}

const char* const kPowerOfTenFormat = "say('10^{%L}', '$10^{%L}$')";

std::string enhanced_text_to_latex(const std::string& enhanced) {
  constexpr std::string_view kItalic = "{/:Italic ";
  const std::string_view text = enhanced;
  std::string latex;
  for (std::size_t position = 0; position < text.size();) {
    const auto rest = text.substr(position);
    if (rest.starts_with(kItalic)) {
      const auto end = std::min(rest.find('}'), rest.size());
      latex += fmt::format("${}$", rest.substr(kItalic.size(), end - kItalic.size()));
      position += end + 1;
    } else if (rest[0] == '\\' && rest.size() > 1) {
      latex += latex_escape(rest[1]);
      position += 2;
    } else if (rest[0] == '_' || rest[0] == '^') {
      ++position;
      std::string argument_text(take_argument(text, position));
      boost::algorithm::replace_all(argument_text, kMinus, "-");
      latex += fmt::format("${}{{{}}}$", rest[0], argument_text);
    } else {
      std::string_view from = rest.substr(0, 1), to = from;
      for (const auto& [letter, symbol] : kLatexSymbols) {
        if (rest.starts_with(letter)) from = letter, to = symbol;
      }
      latex += to;
      position += from.size();
    }
  }
  return latex;
}

std::string gnuplot_string_expression(const std::string& enhanced) {
  const std::string latex = enhanced_text_to_latex(enhanced);
  return latex == enhanced
             ? quote_for_gnuplot(enhanced)
             : fmt::format("say({}, {})", quote_for_gnuplot(enhanced), quote_for_gnuplot(latex));
}

std::string literal_gnuplot_expression(const std::string& text) {
  return gnuplot_string_expression(escape_enhanced_text(text));
}

std::string variable_in_plain_text(transform::StateVariable variable) {
  return variable == transform::StateVariable::y ? "y" : "y\u2032";
}

std::string density_in_plain_text(transform::StateVariable variable) {
  return fmt::format("p({})", variable_in_plain_text(variable));
}

}  // namespace fpkcheck::report
