#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "report/figure/figure.hpp"

/// Texts of the contents of figures.
namespace fpkcheck::tests {

/// The names of the series with points that a panel shows.
inline std::vector<std::string> names_in(const report::FigurePanel& panel) {
  std::vector<std::string> names;
  for (const auto& series : panel.series) {
    if (!series.points.empty()) names.push_back(series.name);
  }
  return names;
}

inline const report::FigureSeries& series_of(const report::FigurePanel& panel,
                                             const std::string& name) {
  return *std::ranges::find(panel.series, name, &report::FigureSeries::name);
}

/// The points of a series, "0.6 0.4 open, 0.7 nan"; "" if the panel has no such series.
inline std::string points_of(const report::FigurePanel& panel, const std::string& name) {
  std::string text;
  for (const auto& series : panel.series) {
    if (series.name != name) continue;
    for (const auto& point : series.points) {
      text += fmt::format("{}{:g} {:.4g}{}", text.empty() ? "" : ", ", point.x, point.y,
                          point.open ? " open" : "");
    }
  }
  return text;
}

inline std::string tics_of(const report::FigureAxis& axis) {
  std::string text;
  for (const auto& tic : axis.tics) {
    text += fmt::format("{}{} {:g}", text.empty() ? "" : ", ", tic.label, tic.place);
  }
  return text;
}

}  // namespace fpkcheck::tests
