#pragma once

#include <string>

/// Texts of pictures, which LaTeX wants in its own way.
namespace fpkcheck::report {

/// What shows the same in LaTeX as a text of ours in gnuplot's enhanced mode: italics as formulas,
/// Greek letters, exponents, and whatever LaTeX would take for a command letter by letter.
std::string latex_of(const std::string& enhanced);

/// An enhanced text as a string expression of a script (script: figure_output), for all formats.
std::string gnuplot_text(const std::string& enhanced);

/// A text that is shown letter by letter, as such an expression.
std::string gnuplot_literal(const std::string& text);

/// U+2212, which is what gnuplot's own numbers have for a minus.
inline constexpr const char* kMinus = "\u2212";

/// A number's text with that for each hyphen.
std::string with_minus(std::string number);

/// "+1.2 × 10^{−3}" in enhanced text; "0" of 0.
std::string power_text(double value);

/// For `set format` of a logarithmic axis: powers of ten.
extern const char* const kPowersOfTen;

}  // namespace fpkcheck::report
