#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// A varied key as an axis of figures. Numbers have a linear or, where they are spaced
/// logarithmically, a logarithmic axis; words have equidistant positions.
class KeyAxis {
 public:
  /// @param place index of the key in the plan's axes
  KeyAxis(const Plan& plan, std::size_t place);

  const std::string& key() const { return key_; }
  bool is_words() const { return is_words_; }
  bool is_logarithmic() const { return is_logarithmic_; }
  /// The distinct values of all points: numbers by size, words in the order of the list.
  const std::vector<base::Value>& values() const { return values_; }
  /// Text of a value: "0.8", "gaussian".
  static std::string text_of(const base::Value& value);

  /// Coordinate of a value on the gnuplot axis.
  double coordinate(const base::Value& value) const;
  /// Coordinate relative to the axis from the first to the last of values(), 0 .. 1.
  double relative_coordinate(const base::Value& value) const;
  /// Gnuplot commands for label, scale, range and tics of the axis.
  /// @param letter 'x' or 'y'
  std::string commands(char letter) const;

  /// Gnuplot command for the label alone, the same for cells.
  std::string label_command(char letter) const;

  /// Index of a value in values(): the position of its cell in a map, whose cells have equal
  /// widths.
  std::size_t cell_of(const base::Value& value) const;
  /// Gnuplot commands for label, range and tics of an axis of cells.
  std::string cell_commands(char letter) const;

 private:
  std::string key_, label_;
  bool is_words_ = false, is_logarithmic_ = false, is_even_ = false;
  std::vector<base::Value> values_;
};

}  // namespace fpkcheck::sweep
