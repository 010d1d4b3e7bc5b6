#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/options.hpp"

/// The model of a figure that consists of points and lines. A figure is made once from results;
/// figure_script writes the figure for gnuplot, figure_plots (report/page/figure_plots.hpp) for the
/// page.
namespace fpkcheck::report {

struct FigurePoint {
  double x, y;
  bool open = false;        ///< whether the mark is open: the solution is not ok
  std::string name = "";    ///< name that the page shows beside the pointer
  std::string label = "";   ///< text beside the mark, on the page only
  std::string colour = "";  ///< colour of the mark on the page; "" for the colour of the series
};

/// Points with marks, a line through the points, or both.
struct FigureSeries {
  std::string name;   ///< entry of the legend, plain text
  std::string group;  ///< the page hides and shows the series of a group together
  std::string colour;
  std::string dash = "";  ///< dash style of plotly.js: solid, dot, dash, longdash; "" for no line
  double line_width = 2;
  std::string symbol = "";  ///< symbol of plotly.js; "" for no marks
  double mark_size = 1.3;   ///< in units of gnuplot's point size
  std::vector<FigurePoint> points = {};
};

struct FigureAxis {
  std::string label;  ///< in gnuplot's enhanced text
  double from, to;
  bool is_logarithmic = false;
  double tic_step = 0;  ///< 0 for an automatic step
};

struct FigurePanel {
  std::string id;       ///< part of the id of the plot on the page
  std::string title;    ///< title in a picture, after the letter of the panel
  std::string caption;  ///< caption on the page, plain text
  FigureAxis x, y;
  std::vector<FigureSeries> series = {};
};

struct Figure {
  std::vector<FigurePanel> panels;
};

/// A gnuplot script with the data that draws the panels side by side, or one below the other in a
/// single journal column, with a common legend.
/// @pre the figure has at least one panel
std::string figure_script(const Figure& figure, const problem::Problem& problem,
                          const std::string& file_stem, FigureWidth width);

}  // namespace fpkcheck::report
