#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/identity.hpp"
#include "transform/marginal.hpp"

/// What the pictures of all studies are made of: parts of gnuplot scripts.
namespace fpkcheck::study {

/// Where a panel stands, in fractions of the picture.
struct Place {
  double left, right, top, bottom;
};
std::string margins(const Place& place);

/// Named data within a script.
/// @param rows each ended by a newline
std::string data_block(const std::string& name, const std::string& rows);

/// "p(y)" in enhanced text, y or y'.
std::string density_of(transform::Variable variable);

/// Marks differ by shape as well as by colour, for grey print.
struct SeriesLook {
  std::string colour;
  int filled, open;  ///< point types: filled where a density may be trusted
  int dash = 1;      ///< dash type of the line
};

/// Series look as the methods they stand for; those of one family differ in their dashes.
std::vector<SeriesLook> series_looks(std::span<const transform::Identity> identities);

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
