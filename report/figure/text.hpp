#pragma once

#include <string>

#include "transform/solution.hpp"

/// Texts of pictures, in gnuplot's enhanced text and in LaTeX.
namespace fpkcheck::report {

/// Converts gnuplot's enhanced text, as used in these pictures, to LaTeX: italics to formulas,
/// Greek letters, exponents; characters with a meaning in LaTeX are escaped.
std::string to_latex(const std::string& enhanced);

/// Converts gnuplot's enhanced text to a string expression of a gnuplot script that is valid in all
/// figure formats. The expression calls the function say(), which output_commands defines.
std::string gnuplot_text(const std::string& enhanced);

/// Converts a plain text to a string expression of a gnuplot script; the text appears literally in
/// all figure formats.
std::string gnuplot_literal(const std::string& text);

/// The symbol of a variable in plain text, "y" or "y′", and the symbol of its marginal density,
/// "p(y)" or "p(y′)".
std::string variable_text(transform::Variable variable);
std::string density_text(transform::Variable variable);

/// The minus sign U+2212, which gnuplot uses in the numbers that it prints.
inline constexpr const char* kMinus = "\u2212";

/// Replaces the hyphens in the text of a number by minus signs.
std::string with_minus_signs(std::string number);

/// The text of a number in gnuplot's enhanced text: "+1.2 × 10^{−3}", and "0" for the value 0.
std::string scientific_text(double value);

/// The argument of gnuplot's `set format` for a logarithmic axis, which prints powers of ten.
extern const char* const kPowerOfTenFormat;

}  // namespace fpkcheck::report
