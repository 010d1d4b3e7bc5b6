#pragma once

#include <string>
#include <vector>

#include "report/figure/script_parts.hpp"
#include "transform/identity.hpp"

/// What the pictures of all studies are made of.
namespace fpkcheck::study {

using report::data_block;
using report::density_of;
using report::margins;
using report::Place;
using report::series_looks;
using report::SeriesLook;

/// Points of a picture that belong together.
struct Series {
  std::string block;  ///< the name of its data in the script
  std::string label;
  std::string points;  ///< rows of the data, each ended by a newline
  SeriesLook look;
};

/// Neighbouring rows of the same label as a series, which looks as the row in its middle.
/// @param label of a row
/// @param points the text of a row's points; may be empty
template <class Row, class Label, class Points>
std::vector<Series> series_of(const std::vector<Row>& rows, const std::string& block, Label label,
                              Points points) {
  std::vector<Series> all;
  std::vector<transform::Identity> who;
  for (auto row = rows.begin(); row != rows.end();) {
    all.push_back({block + std::to_string(all.size()), label(*row), "", {}});
    const auto first = row;
    for (; row != rows.end() && label(*row) == all.back().label; ++row) {
      all.back().points += points(*row);
    }
    who.push_back((first + (row - first - 1) / 2)->solution.identity);
  }
  const auto looks = series_looks(who);
  for (std::size_t k = 0; k < all.size(); ++k) all[k].look = looks[k];
  return all;
}

}  // namespace fpkcheck::study
