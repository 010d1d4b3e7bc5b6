#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/options.hpp"

/// Size, output commands and title of all pictures.
namespace fpkcheck::report {

/// Size of the layout of a picture in pixels. Letters are 14 or 15 pixels high for every width, so
/// that a narrow picture has fewer panels side by side. On paper letters have 7.5 pt.
struct FigureSize {
  int width;
  int height;
  FigureWidth medium = FigureWidth::screen;
};

/// Width of the layout in pixels.
/// @param on_screen width of the picture on a screen, in pixels
int figure_width(FigureWidth medium, int on_screen);

/// Printed width in mm; 0 on a screen.
double printed_width(FigureWidth medium);

/// The first commands of a gnuplot script, which set terminal and output. The script draws
/// FILE_STEM.png, or with the gnuplot variable format='svg', 'pdf' or 'tex' that format, and
/// refuses other formats. The variable `target` sets another file name.
std::string output_commands(const std::string& file_stem, const FigureSize& size);

/// The title above all panels, broken into lines.
struct FigureTitle {
  std::string command;  ///< the command that begins the multiplot
  int height;           ///< of the title, in pixels
};

/// @param parts of the title, between which lines may break: "case1: c = 0.1, ", "r = 0.98"; plain
///              text
FigureTitle figure_title(const std::vector<std::string>& parts, const FigureSize& size);

/// The title with name and parameters of a problem.
FigureTitle figure_title(const problem::Problem& problem, const FigureSize& size);

}  // namespace fpkcheck::report
