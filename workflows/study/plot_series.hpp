#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/figure/figure.hpp"

namespace fpkcheck::study {

/// Makes a plot series from each group of neighbouring rows with equal name(row), with the points
/// point(row). The series has the plot style of the solution in the middle row of its group.
template <class Row, class Name, class Point>
std::vector<report::FigureSeries> make_empty_series(const std::vector<Row>& rows, Name name,
                                                    Point point) {
  std::vector<report::FigureSeries> all;
  for (auto row = rows.begin(); row != rows.end();) {
    const auto first = row;
    std::vector<report::FigurePoint> points;
    for (; row != rows.end() && name(*row) == name(*first); ++row) {
      if (const std::optional<report::FigurePoint> place = point(*row)) points.push_back(*place);
    }
    const auto middle = first + (row - first - 1) / 2;
    all.push_back(report::make_empty_series(name(*first), middle->solution.identity.plot_style));
    all.back().points = points;
  }
  return all;
}

}  // namespace fpkcheck::study
