#pragma once

#include <string>

/// Texts of pictures, in gnuplot's enhanced text and in LaTeX.
namespace fpkcheck::report {

/// Converts gnuplot's enhanced text, as used in these pictures, to LaTeX: italics to formulas,
/// Greek letters, exponents; characters with a meaning in LaTeX are escaped.
std::string to_latex(const std::string& enhanced);

/// An enhanced text as a string expression in a script, for all formats. The expression uses the
/// function say() of output_commands.
std::string gnuplot_text(const std::string& enhanced);

/// A plain text as such an expression; the text appears literally.
std::string gnuplot_literal(const std::string& text);

/// Minus sign U+2212, as in the numbers that gnuplot prints.
inline constexpr const char* kMinus = "\u2212";

/// The text of a number with minus signs in place of hyphens.
std::string with_minus_signs(std::string number);

/// "+1.2 × 10^{−3}" in enhanced text; "0" of 0.
std::string scientific_text(double value);

/// Argument of `set format` for a logarithmic axis: powers of ten.
extern const char* const kPowerOfTenFormat;

}  // namespace fpkcheck::report
