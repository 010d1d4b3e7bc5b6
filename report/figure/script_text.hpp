#pragma once

#include <string>

#include "transform/marginal_density.hpp"

/// Parts of gnuplot scripts: enhanced texts, LaTeX texts, data blocks, tics, point types and dash
/// types.
namespace fpkcheck::report {

/// The rectangle of the axes of a panel, as fractions of the width and height of the picture.
struct FigurePanelBox {
  double left, right, top, bottom;
};
std::string panel_position_commands(const FigurePanelBox& place);

/// Returns a named data block of a gnuplot script.
/// @param rows rows of the block, each ended by a newline
std::string gnuplot_data_block(const std::string& name, const std::string& rows);

/// Returns the smallest tic distance that is 1, 2 or 5 times a power of ten and divides an axis
/// range into at most `max_steps` steps.
double choose_tick_step(double from, double to, int max_steps = 6);

/// Returns the symbol of a marginal density in gnuplot's enhanced text: "p(y)" or "p(y')".
std::string density_in_enhanced_text(transform::StateVariable variable);

/// The gnuplot point types of one shape: filled for the status `ok`, open for other statuses.
struct GnuplotPointTypes {
  int filled, open;
};
/// Returns the gnuplot point types with the shape of a plotly.js marker, the symbol of a plot
/// style.
GnuplotPointTypes gnuplot_point_types(const std::string& symbol);

/// Returns the number of the gnuplot fill pattern that is most similar to a fill pattern of
/// plotly.js.
int gnuplot_fill_pattern(const std::string& hatch);

/// Returns the dash type if gnuplot accepts this dash type, otherwise "solid". Dash types from
/// files may be invalid.
std::string valid_dash_type(const std::string& dash);

/// Converts gnuplot's enhanced text to LaTeX. In the LaTeX text, italics become formulas, Greek
/// letters and exponents become LaTeX commands, and special characters of LaTeX are escaped.
std::string enhanced_text_to_latex(const std::string& enhanced);

/// Converts gnuplot's enhanced text to a string expression of a gnuplot script that is valid in all
/// figure formats. The returned string expression calls the gnuplot function say(), which
/// gnuplot_output_commands defines.
std::string gnuplot_string_expression(const std::string& enhanced);

/// Converts a plain text to a string expression of a gnuplot script that shows the text literally
/// in all figure formats.
std::string literal_gnuplot_expression(const std::string& text);

/// Returns the symbol of a state variable in plain text, "y" or "y′".
std::string variable_in_plain_text(transform::StateVariable variable);
std::string density_in_plain_text(transform::StateVariable variable);

/// The minus sign U+2212, which gnuplot prints in numbers.
inline constexpr const char* kMinus = "\u2212";

/// Replaces the hyphens in the text of a number by minus signs.
std::string replace_hyphens_by_minus_signs(std::string number);

/// Returns a number with its sign and two significant digits as gnuplot's enhanced text: "+1.2 ×
/// 10^{−3}". The value 0 becomes "0".
std::string scientific_notation_text(double value);

/// Argument of gnuplot's `set format` for a logarithmic axis, which prints powers of ten.
extern const char* const kPowerOfTenFormat;

}  // namespace fpkcheck::report
