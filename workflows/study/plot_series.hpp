#pragma once

#include <string>
#include <vector>

#include "report/figure/script_parts.hpp"
#include "transform/identity.hpp"

/// Parts of gnuplot scripts that the figures of all studies share.
namespace fpkcheck::study {

using report::data_block;
using report::density_symbol;
using report::panel_position_commands;
using report::PanelBox;
using report::series_styles;
using report::SeriesStyle;

/// A curve of a figure with points, label and plot style.
struct PlotSeries {
  std::string block;  ///< name of its data block in the script
  std::string label;
  std::string points;  ///< lines of the data block, each ended by a newline
  SeriesStyle plot_style;
};

/// Makes a series from each group of neighbouring rows with the same label. The plot style of the
/// series is the style of the group's middle row.
/// @param label function that returns the label of a row
/// @param points function that returns the lines of a row's points; these lines may be empty
template <class Row, class Label, class Points>
std::vector<PlotSeries> make_series(const std::vector<Row>& rows, const std::string& block,
                                    Label label, Points points) {
  std::vector<PlotSeries> all;
  std::vector<transform::SolutionIdentity> identities;
  for (auto row = rows.begin(); row != rows.end();) {
    all.push_back({block + std::to_string(all.size()), label(*row), "", {}});
    const auto first = row;
    for (; row != rows.end() && label(*row) == all.back().label; ++row) {
      all.back().points += points(*row);
    }
    identities.push_back((first + (row - first - 1) / 2)->solution.identity);
  }
  const auto looks = series_styles(identities);
  for (std::size_t k = 0; k < all.size(); ++k) all[k].plot_style = looks[k];
  return all;
}

}  // namespace fpkcheck::study
