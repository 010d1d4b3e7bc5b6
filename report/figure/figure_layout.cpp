#include "report/figure/figure_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

constexpr double kPointsPerInch = 72, kMillimetresPerInch = 25.4;
// Letter height on a screen of 96 dpi, 11 points in units of pixels, and letter height on paper in
// points. Journals require at least 7 points.
constexpr double kLetterPixels = 11 * 96 / kPointsPerInch, kLetterPoints = 7.5;
// Resolution of a PNG for print, in dpi.
constexpr double kPrintResolution = 300;

// Points per pixel of a layout on paper. A PDF for the screen has the same ratio of points per
// pixel as a printed PDF, so that the letters of all PDF files have equal size.
constexpr double kPointsPerPixel = kLetterPoints / kLetterPixels;

double png_scale(FigureWidth medium) {
  return medium == FigureWidth::screen ? 1 : kPointsPerPixel * kPrintResolution / kPointsPerInch;
}

std::string svg_terminal(const FigureSize& size) {
  return fmt::format(
      "set terminal svg size {},{} enhanced font 'sans-serif,14' background rgb 'white'",
      size.width, size.height);
}

std::string png_terminal(const FigureSize& size) {
  const double scale = png_scale(size.medium);
  const std::string scaled =
      scale == 1 ? ""
                 : fmt::format(" fontscale {0:.4g} linewidth {0:.4g} pointscale {0:.4g}", scale);
  return fmt::format(
      "pngcairo size {:.0f},{:.0f} enhanced font 'sans-serif,11'{} background rgb "
      "'white'",
      scale * size.width, scale * size.height, scaled);
}

// The sizes are in inches. The factor 2 compensates that the Cairo terminal draws lines at half of
// their width.
std::string cairo_scale(const FigureSize& size) {
  return fmt::format("size {:.4f},{:.4f} linewidth {:.4g} pointscale {:.4g}",
                     size.width * kPointsPerPixel / kPointsPerInch,
                     size.height * kPointsPerPixel / kPointsPerInch, 2 * kPointsPerPixel,
                     kPointsPerPixel);
}

// Left margin of a panel with tics and axis label, in pixels.
constexpr int kPanelLeftMargin = 92;

// Letter width and line height of the larger font (the font of SVG pictures), in pixels, that
// gnuplot assumes.
constexpr double kLetterWidth = 10.5, kLineHeight = 25.2;
constexpr double kLegendMargin = 16;
constexpr double kStripLeft = 0.02,
                 kStripRight = 0.98;  // ends of the legend strip, as fractions of the picture width
constexpr int kMaxLegendColumns = 4;

int legend_column_count(const FigureLegend& legend, int width) {
  std::size_t longest = 0;
  for (const auto& entry : legend.entries) longest = std::max(longest, entry.label.size());
  const double entry_width =
      kLetterWidth * (static_cast<double>(longest) + legend.sample_length + 1);
  return std::clamp(static_cast<int>((kStripRight - kStripLeft) * width / entry_width), 1,
                    kMaxLegendColumns);
}

}  // namespace

int layout_width_in_pixels(FigureWidth medium, int screen_width_pixels) {
  if (medium == FigureWidth::screen) return screen_width_pixels;
  return static_cast<int>(printed_width_mm(medium) / kMillimetresPerInch * kPointsPerInch /
                          kPointsPerPixel);
}

double printed_width_mm(FigureWidth medium) {
  return medium == FigureWidth::two_columns ? 170 : medium == FigureWidth::one_column ? 85 : 0;
}

std::string gnuplot_output_commands(const std::string& file_stem, const FigureSize& size) {
  return fmt::format(
      "# Drawn by: gnuplot {0}.gp, or gnuplot -e \"format='svg'\" {0}.gp; likewise pdf, and tex\n"
      "# for LaTeX: {0}.tex with a {0}.pdf that it includes\n"
      "if (!exists(\"format\")) format = 'png'\n"
      "if (format ne 'png' && format ne 'svg' && format ne 'pdf' && format ne 'tex') "
      "exit error \"format = '\".format.\"' (must be png, svg, pdf or tex)\"\n"
      "if (!exists(\"target\")) target = {1}.'.'.format\n"
      "say(enhanced, latex) = format eq 'tex' ? latex : enhanced\n"
      "set encoding utf8\n"
      "set minussign\n"
      "set format x say('%h', '$%h$')\n"
      "if (format eq 'svg') {{\n"
      "  {2}\n"
      "}}\n"
      "if (format eq 'pdf') {{\n"
      "  set terminal pdfcairo {3} enhanced font 'sans-serif,11' fontscale {4:.4g} background rgb "
      "'white'\n"
      "}}\n"
      "if (format eq 'tex') {{\n"
      "  set terminal cairolatex pdf input header '\\fontsize{{{5:g}}}{{{9:g}}}\\selectfont' {3} "
      "font ',{5:g}' background rgb 'white'\n"
      "}}\n"
      "if (format eq 'png') {{\n"
      "  if (strstrt(GPVAL_TERMINALS, 'pngcairo') > 0) {{\n"
      "    set terminal {6}\n"
      "  }} else {{\n"
      "    set terminal png size {7},{8} enhanced\n"
      "  }}\n"
      "}}\n"
      "set output target\n\n",
      file_stem, quote_for_gnuplot(file_stem), svg_terminal(size), cairo_scale(size),
      kPointsPerPixel, kLetterPoints, png_terminal(size), size.width, size.height,
      1.2 * kLetterPoints);
}

FigureTitle make_figure_title(const std::vector<std::string>& parts, const FigureSize& size) {
  constexpr int kTitleLine = 24, kFirstLine = 36;
  // The font of the title is smaller on paper than on a screen, to save space.
  const int points = size.medium == FigureWidth::screen ? 14 : 11;
  const double letter = 0.6 * points * 96 / kPointsPerInch;
  std::vector<std::string> lines{""};
  for (const auto& part : parts) {
    const auto letters = static_cast<double>(lines.back().size() + part.size());
    if (!lines.back().empty() && letters * letter > size.width) lines.emplace_back();
    lines.back() += part;
  }
  // The title is in double quotes, since gnuplot reads \n as a line break only within double
  // quotes.
  std::vector<std::string> shown;
  for (auto& line : lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    shown.push_back(literal_gnuplot_expression(line));
  }
  return {
      fmt::format("set multiplot title {} font ',{}'\n\n", fmt::join(shown, ".\"\\n\"."), points),
      kFirstLine + static_cast<int>(lines.size() - 1) * kTitleLine};
}

// All title text is upright, without italics, since viewers of SVG drop the spaces beside a change
// of font.
std::vector<std::string> problem_title_parts(const problem::Problem& problem) {
  std::vector<std::string> parts{problem.name + ": "};
  const std::string parameters = problem::non_default_parameters_text(problem, true);
  for (std::size_t from = 0; from < parameters.size();) {
    const auto end = parameters.find(' ', parameters.find_first_of(",;", from));
    const auto to = end == std::string::npos ? parameters.size() : end + 1;
    parts.push_back(parameters.substr(from, to - from));
    from = to;
  }
  return parts;
}

FigureSize PanelGrid::size() const {
  const int row = above + panel_height + below;
  return {.width = width, .height = title_height + rows * row + legend_height, .medium = medium};
}

FigurePanelBox PanelGrid::panel_box(int row, int column) const {
  const double height = size().height;
  const double column_width = static_cast<double>(width - right_margin) / columns;
  const double top = title_height + row * (above + panel_height + below) + above;
  return {.left = (column * column_width + kPanelLeftMargin) / width,
          .right = ((column + 1) * column_width - panel_right_margin) / width,
          .top = 1 - top / height,
          .bottom = 1 - (top + panel_height) / height};
}

PanelGrid make_panel_grid(FigureWidth medium, int screen_width_pixels) {
  PanelGrid grid{.medium = medium, .width = layout_width_in_pixels(medium, screen_width_pixels)};
  if (medium == FigureWidth::one_column) {
    grid.above = 36;
    grid.below = 62;
  }
  return grid;
}

int legend_height(const FigureLegend& legend, int width) {
  const auto rows =
      std::ceil(static_cast<double>(legend.entries.size()) / legend_column_count(legend, width));
  return static_cast<int>(std::ceil(kLegendMargin + kLineHeight * rows));
}

std::string legend_strip_commands(const FigureLegend& legend, const FigureSize& size) {
  std::vector<std::string> plots;
  for (const auto& [plot, label] : legend.entries) {
    plots.push_back(fmt::format("{} title {}", plot, literal_gnuplot_expression(label)));
  }
  const double top = legend_height(legend, size.width) - kLegendMargin / 4,
               bottom = kLegendMargin / 4;
  return fmt::format(
      "unset title\nunset xlabel\nunset ylabel\nunset border\nunset tics\nunset grid\n"
      "unset logscale\n"
      "set lmargin at screen {}\nset rmargin at screen {}\n"
      "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set key center center horizontal maxcols {} Left reverse samplen {} spacing (format eq 'tex' ? 1.8 : 1.2)\n"
      "plot [0:1] [0:1] {}\n",
      kStripLeft, kStripRight, top / size.height, bottom / size.height,
      legend_column_count(legend, size.width), legend.sample_length,
      fmt::join(plots, ", \\\n     "));
}

}  // namespace fpkcheck::report
