#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::report {

/// One plot of the page.
struct Plot {
  std::string id;       ///< of its element in the page
  std::string caption;  ///< plain text
  /// JSON for plotly.js, "data" (traces) and "layout"; and "arrays", numbers that several traces
  /// share: a trace's "@name" stands for the array of that name. "height" is in pixels, without the
  /// legend. Traces with the same "legendgroup" are switched together in all plots of a case.
  std::string figure;
};

/// Plots beside each other where the screen is wide enough, else below each other: the elements
/// that page.js draws into.
std::string plots_html(const std::vector<Plot>& plots);

/// The plots of one case as page.js reads them, in JSON: {"id", "figure"} each.
std::string plots_json(const std::vector<Plot>& plots);

/// A text as plotly.js is to show it: it takes names, titles and labels for a kind of HTML.
std::string plotly_text(std::string_view text);

/// A name for legends, as plotly.js is to show it: the id, with the status of a solution that is
/// not ok.
std::string legend_name(const transform::Solution& solution);

/// A dash type of gnuplot, "(10,4)", as plotly.js has it: "10px,4px".
std::string plotly_dash(const std::string& gnuplot_dash);

/// A variable as the page writes it, and its density: y' and p(y').
std::string variable_text(transform::Variable variable);
std::string density_text(transform::Variable variable);

}  // namespace fpkcheck::report
