#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace fpkcheck::compare {

/// One plot of the page.
struct Plot {
  std::string id;       ///< of its element in the page
  std::string caption;  ///< plain text
  /// For plotly.js, "data" (traces) and "layout"; and "arrays", numbers that several traces share:
  /// a trace's "@name" stands for the array of that name. "height" is in pixels, without the
  /// legend. Traces with the same "legendgroup" are switched together in all plots of a case.
  nlohmann::ordered_json figure;
};

/// The element that page.js draws a plot into.
std::string plot_html(const Plot& plot);

/// Plots beside each other where the screen is wide enough, else below each other.
std::string plots_html(const std::vector<Plot>& plots);

/// The plots of one case as page.js reads them: {"id", "figure"} each.
nlohmann::ordered_json plots_json(const std::vector<Plot>& plots);

/// A variable as the page writes it: y or y'.
std::string variable_text(const std::string& variable);

}  // namespace fpkcheck::compare
