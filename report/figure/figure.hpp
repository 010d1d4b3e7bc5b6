#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/figure/figure_options.hpp"
#include "transform/solution_identity.hpp"

/// Data structures that describe a figure independently of its output format (gnuplot or
/// plotly.js). The function make_gnuplot_script() converts a Figure to a gnuplot script. The
/// function make_page_plots() (report/page/page_plots.hpp) converts a Figure to plots of the report
/// page.
namespace fpkcheck::report {

/// A point of a series. The line of a data series has a gap at a point with a non-finite
/// coordinate, or with a coordinate <= 0 on a logarithmic axis.
struct FigurePoint {
  double x, y;
  bool open = false;        ///< whether the mark is open, for a status other than `ok`
  std::string name = "";    ///< name of the point, which the page shows beside the mouse pointer
  std::string label = "";   ///< text beside the mark, on the page only
  std::string colour = "";  ///< colour of the mark on the page; if empty, the colour of the series
  /// Ends of the confidence interval at a point of a series without a line; NaN without an
  /// interval. Confidence intervals are error bars in a picture and a band on the report page.
  double lower = std::numeric_limits<double>::quiet_NaN(), upper = lower;
  double width = 0;  ///< width of a bar, in units of the x axis
};

/// A data series of a figure: points with marks, a line through the points, or marks and a line.
/// Data series of a figure with the same name share a legend entry.
struct FigureSeries {
  std::string name;        ///< name of the series in the legend, plain text
  std::string group = "";  ///< the page hides and shows the series of a group together
  std::string colour;
  std::string dash = "";  ///< dash type of gnuplot, such as "(10,4)"; empty for no line
  double line_width = 2;
  std::string symbol = "";                    ///< mark symbol of plotly.js; empty for no marks
  double mark_size = 1.3;                     ///< in units of gnuplot's point size
  std::size_t mark_step = 1, first_mark = 0;  ///< a mark at each step-th point
  bool is_area = false;    ///< whether the area below the line is filled, in a paler colour
  bool is_bars = false;    ///< whether each point is the top of a bar; an open bar is paler
  std::string hatch = "";  ///< fill pattern of bars in plotly.js; empty for a solid fill
  std::vector<FigurePoint> points = {};
  std::string legend_colour = "";  ///< colour of a legend entry that several series share
  std::string note = "";           ///< plain text after the name in the legend of a picture
  std::size_t rank = 0;            ///< sort key of the legend entries
  bool is_hidden = false;          ///< whether the page initially hides the series
};

/// Returns a series without points, with the colour, dash type and symbol of a plot style.
FigureSeries make_empty_figure_series(const std::string& name,
                                      const transform::PlotStyle& plot_style);

struct AxisTickMark {
  std::string label;  ///< label in gnuplot's enhanced text
  double place;

  bool operator==(const AxisTickMark&) const = default;
};

struct FigureAxis {
  std::string label;  ///< label in gnuplot's enhanced text
  double from, to;
  bool is_logarithmic = false;
  double tic_step = 0;                  ///< distance of the tics; 0 for an automatic distance
  std::vector<AxisTickMark> tics = {};  ///< tics with labels; empty for automatic tics
  bool rotated_tics = false;            ///< whether long labels of tics are slanted in a picture

  bool operator==(const FigureAxis&) const = default;
};

/// Range of the coordinates of points; `least` exceeds `greatest` if no point was counted.
struct CoordinateRange {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;

  bool is_empty() const { return greatest < least; }
};
/// Returns the range of all finite coordinates of the points that are larger than `above`.
CoordinateRange coordinate_range(const std::vector<FigureSeries>& all,
                                 double FigurePoint::*coordinate,
                                 double above = -std::numeric_limits<double>::infinity());

/// Makes a logarithmic axis whose range contains the x or y coordinates of all points, with a
/// margin for marks and labels.
FigureAxis logarithmic_axis(const std::string& label, const std::vector<FigureSeries>& all,
                            double FigurePoint::*coordinate);

/// Makes a linear axis whose range contains the x or y coordinates of all points, with a margin.
FigureAxis linear_axis(const std::string& label, const std::vector<FigureSeries>& all,
                       double FigurePoint::*coordinate);

/// A heat map behind the series of its panel: colours for values on a grid of equal cells or at
/// single points. Non-finite values have no colour.
struct FigureHeatMap {
  std::array<double, 2> x_range, y_range;  ///< outer edges of the cells
  std::size_t columns;
  std::vector<double> values;  ///< values in rows of constant y, from the lowest y
  FigureAxis colour_axis;
  /// Positions (from 0 to 1) and colours that define the colour scale of the heat map.
  std::vector<std::pair<double, std::string>> colours;
  std::vector<std::array<double, 3>> discs = {};  ///< coordinates x, y and value of single points
  std::string no_value_name = "";                 ///< legend entry of cells without a colour
  double disc_size = 1;                           ///< in units of gnuplot's point size
  /// If root_scale is positive, a value v of the heat map is a signed square root, and the report
  /// page shows the number v |v| root_scale beside the mouse pointer.
  double root_scale = 0;
  std::string quantity = "";
};

/// Positions and colours of a diverging colour scale with white for 0, which colour-blind readers
/// can distinguish.
inline constexpr std::pair<double, const char*> kDivergingColours[] = {
    {0, "#053061"},   {0.2, "#2166ac"}, {0.4, "#92c5de"}, {0.5, "#ffffff"},
    {0.6, "#f4a582"}, {0.8, "#b2182b"}, {1, "#67001f"}};

/// Positions and colours of a sequential colour scale with white for 0. The colours of the
/// sequential scale differ most among small values.
inline constexpr std::pair<double, const char*> kSequentialColours[] = {
    {0, "#FFFFFF"},   {0.04, "#E4F0EE"}, {0.12, "#A9DAC9"}, {0.3, "#45B29D"},
    {0.5, "#2A788E"}, {0.75, "#3B4A8C"}, {1, "#3A0F4F"}};

/// A panel of a figure. On the report page, panels with the same id are the rows of one plot,
/// beginning with the lowest row.
struct FigurePanel {
  std::string id = "";  ///< part of the id of the plot on the page; empty for no plot
  /// Title of the panel in a picture, after the panel's letter, in gnuplot's enhanced text.
  std::string title;
  std::string caption = "";  ///< caption on the page, plain text
  std::string letter = "";   ///< letter of the panel in a picture; empty for the next letter
  std::string note = "";     ///< plain text at the top of the vertical line x = 0
  FigureAxis x, y;
  std::vector<FigureSeries> series = {};
  std::optional<FigureHeatMap> map = {};
  /// Name of the choice, in a control of the report page, that shows this panel. Panels with
  /// different choices share one place on the report page, where a control selects the visible
  /// panel.
  std::string choice = "";
};

struct Figure {
  /// Parts of the figure title in plain text; a picture may break the title into lines between two
  /// parts.
  std::vector<std::string> title = {};
  std::vector<FigurePanel> panels = {};
  std::string legend_note = "";  ///< text in the legend without a line sample
  int columns = 2;          ///< columns of panels; always one column in a single journal column
  int screen_width = 1100;  ///< width in pixels on a screen
  int panel_height = 300;   ///< height in pixels of the axes of a panel on a screen
};

/// Returns a gnuplot script with data that draws the panels of a figure row by row, with a common
/// legend. A single panel in the last row of a figure fills the width of the picture.
/// @pre the figure has at least one panel
std::string make_gnuplot_script(const Figure& figure, const std::string& file_stem,
                                FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
