#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/options.hpp"

/// What all pictures share.
namespace fpkcheck::report {

/// Of a picture as it is laid out, in pixels: its letters are 14 or 15 of them high whatever the
/// width, so that what is narrower has less beside one another. On paper they are of 7.5 pt.
struct FigureSize {
  int width;
  int height;
  FigureWidth medium = FigureWidth::screen;
};

/// Pixels across.
/// @param on_screen what the picture takes there
int figure_width(FigureWidth medium, int on_screen);

/// Millimetres across; 0 on a screen.
double millimetres(FigureWidth medium);

/// The first lines of a gnuplot script: it draws FILE_STEM.png or, with format='svg', 'pdf' or
/// 'tex', that, and refuses other formats; the gnuplot variable `target` names another file.
std::string figure_output(const std::string& file_stem, const FigureSize& size);

/// What stands above all panels, in as many lines as it takes.
struct FigureTitle {
  std::string command;  ///< that begins the multiplot
  int height;           ///< pixels from the top
};

/// @param parts that a line may end after: "case1: c = 0.1, ", "r = 0.98"; shown letter by letter
FigureTitle figure_title(const std::vector<std::string>& parts, const FigureSize& size);

/// A case's name and parameters.
FigureTitle figure_title(const problem::Problem& problem, const FigureSize& size);

}  // namespace fpkcheck::report
