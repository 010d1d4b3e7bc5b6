#include "report/figure/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "report/figure/gnuplot.hpp"

namespace fpkcheck::report {
namespace {

constexpr std::pair<std::string_view, std::string_view> kOfLatex[] = {
    {"−", "$-$"},       {"×", "$\\times$"}, {"λ", "$\\lambda$"}, {"μ", "$\\mu$"},
    {"σ", "$\\sigma$"}, {"Δ", "$\\Delta$"}, {"≤", "$\\le$"},     {"²", "$^2$"},
    {"′", "$'$"},       {"|", "$|$"},       {"<", "$<$"},        {">", "$>$"},
    {"#", "\\#"},       {"$", "\\$"},       {"%", "\\%"},        {"&", "\\&"},
    {"~", "\\~{}"},     {"--", "-{}-"},
};
// LaTeX code for the character after a backslash in enhanced text.
constexpr std::pair<char, std::string_view> kEscaped[] = {
    {'_', "\\_"}, {'^', "\\^{}"}, {'{', "\\{"},   {'}', "\\}"},
    {'@', "@"},   {'&', "\\&"},   {'~', "\\~{}"}, {'\\', "\\textbackslash{}"},
};

std::string_view escaped(char c) {
  for (const auto& [letter, latex] : kEscaped) {
    if (letter == c) return latex;
  }
  return "";
}

// The text within braces that begin here, or a single letter; advances the position behind both.
std::string_view argument(std::string_view text, std::size_t& at) {
  const bool in_braces = at < text.size() && text[at] == '{';
  const auto from = in_braces ? at + 1 : at;
  const auto to = in_braces ? std::min(text.find('}', from), text.size()) : from + 1;
  at = in_braces ? to + 1 : to;
  return from < text.size() ? text.substr(from, to - from) : "";
}

}  // namespace

std::string with_minus(std::string number) {
  boost::algorithm::replace_all(number, "-", kMinus);
  return number;
}

std::string power_text(double value) {
  if (value == 0) return "0";
  const std::string text = fmt::format("{:+.1e}", value);
  const auto e = text.find('e');
  return with_minus(
      fmt::format("{} × 10^{{{}}}", text.substr(0, e), std::stoi(text.substr(e + 1))));
}

const char* const kPowersOfTen = "say('10^{%L}', '$10^{%L}$')";

std::string latex_of(const std::string& enhanced) {
  constexpr std::string_view kItalic = "{/:Italic ";
  const std::string_view text = enhanced;
  std::string latex;
  for (std::size_t at = 0; at < text.size();) {
    const auto rest = text.substr(at);
    if (rest.starts_with(kItalic)) {
      const auto end = std::min(rest.find('}'), rest.size());
      latex += fmt::format("${}$", rest.substr(kItalic.size(), end - kItalic.size()));
      at += end + 1;
    } else if (rest[0] == '\\' && rest.size() > 1) {
      latex += escaped(rest[1]);
      at += 2;
    } else if (rest[0] == '_' || rest[0] == '^') {
      ++at;
      std::string of(argument(text, at));
      boost::algorithm::replace_all(of, kMinus, "-");
      latex += fmt::format("${}{{{}}}$", rest[0], of);
    } else {
      std::string_view from = rest.substr(0, 1), to = from;
      for (const auto& [letter, of_latex] : kOfLatex) {
        if (rest.starts_with(letter)) from = letter, to = of_latex;
      }
      latex += to;
      at += from.size();
    }
  }
  return latex;
}

std::string gnuplot_text(const std::string& enhanced) {
  const std::string latex = latex_of(enhanced);
  return latex == enhanced
             ? gnuplot_string(enhanced)
             : fmt::format("say({}, {})", gnuplot_string(enhanced), gnuplot_string(latex));
}

std::string gnuplot_literal(const std::string& text) { return gnuplot_text(without_marks(text)); }

}  // namespace fpkcheck::report
