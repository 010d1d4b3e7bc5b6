#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/options.hpp"

/// Size, output commands and title that all pictures share.
namespace fpkcheck::report {

/// Size of the layout of a picture in pixels. Letters are 14 or 15 pixels high for every width, so
/// that a narrow picture has fewer panels side by side. The letters of a printed picture have 7.5
/// pt.
struct FigureSize {
  int width;
  int height;
  FigureWidth medium = FigureWidth::screen;
};

/// Width of the layout of a figure in pixels.
/// @param screen_width_pixels width of the picture on a screen, in pixels
int figure_width(FigureWidth medium, int screen_width_pixels);

/// Printed width of a figure in mm; 0 for a figure on a screen.
double printed_width_mm(FigureWidth medium);

/// The first commands of a gnuplot script, which set terminal and output. The script draws
/// FILE_STEM.png. The gnuplot variable format='svg', 'pdf' or 'tex' selects another format; the
/// script refuses all other values. The gnuplot variable `target` sets another file name.
std::string gnuplot_output_commands(const std::string& file_stem, const FigureSize& size);

/// The title of a figure above all panels, broken into lines.
struct FigureTitle {
  std::string command;  ///< the command that begins the multiplot
  int height;           ///< of the title, in pixels
};

/// @param parts parts of the title in plain text, between which the title may be broken into lines:
///              "case1: c = 0.1, ", "r = 0.98"
FigureTitle figure_title(const std::vector<std::string>& parts, const FigureSize& size);

/// The name and the parameters of a problem as the parts of a figure's title.
std::vector<std::string> problem_title(const problem::Problem& problem);
FigureTitle figure_title(const problem::Problem& problem, const FigureSize& size);

}  // namespace fpkcheck::report
