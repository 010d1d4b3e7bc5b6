#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/figure/figure.hpp"

namespace fpkcheck::report {

struct ReportPagePlot {
  std::string id;       ///< id of the HTML element of the plot
  std::string caption;  ///< caption of the plot, plain text
  /// A plot as JSON for plotly.js, with the keys "data" (traces), "layout" and "arrays" (numbers
  /// that several traces share). In a plotly.js trace, the text "@name" represents the array of
  /// numbers with the key `name`. The value "height" of a plot, in pixels, excludes the legend.
  /// Traces with the same "legendgroup" are hidden or shown together in all plots of a case.
  std::string figure;
};

/// Returns the HTML elements in which page.js draws the plots, side by side on a wide screen.
std::string plots_html(const std::vector<ReportPagePlot>& plots);

/// Returns the plots of one case as JSON for the script page.js, with an element {"id", "figure"}
/// for each plot.
std::string plots_json(const std::vector<ReportPagePlot>& plots);

/// Escapes a text for plotly.js, which interprets names, titles and labels as a subset of HTML.
std::string escape_plotly_text(std::string_view text);

/// Converts gnuplot's enhanced text to the HTML of plotly.js: italics, subscripts, superscripts and
/// escaped characters.
std::string enhanced_text_to_plotly(std::string_view enhanced);

/// Converts a dash type of gnuplot, such as "(10,4)", to a dash type of plotly.js, "10px,4px".
std::string plotly_dash_type(const std::string& gnuplot_dash);

/// Converts a figure to plots of the report page. Consecutive panels of the figure with the same id
/// become the rows of one plot, and panels without an id are omitted.
/// @param prefix prefix of the ids of the plots
std::vector<ReportPagePlot> make_page_plots(const Figure& figure, const std::string& prefix);

}  // namespace fpkcheck::report
