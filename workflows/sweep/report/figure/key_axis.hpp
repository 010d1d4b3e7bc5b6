#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/figure/figure.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// A varied key as an axis of figures. The axis of a numeric key is linear, or logarithmic if the
/// values are spaced logarithmically. A key whose values are words has a categorical axis with
/// equidistant positions.
class KeyAxis {
 public:
  /// @param place index of the key in the plan's axes
  KeyAxis(const Plan& plan, std::size_t place);

  const std::string& key() const { return key_; }
  bool has_words() const { return is_words_; }
  bool is_logarithmic() const { return is_logarithmic_; }
  /// The distinct values of the key over all points: numbers in increasing order, words in the
  /// order of the list.
  const std::vector<base::Value>& values() const { return values_; }
  /// The text of a value on the axis: "0.8", "gaussian".
  static std::string value_text(const base::Value& value);

  /// The coordinate of a value on the axis.
  double coordinate(const base::Value& value) const;
  /// The coordinate of a value relative to the axis: 0 for the first of values(), 1 for the last.
  double relative_coordinate(const base::Value& value) const;
  /// The axis with label, scale, range and tics.
  report::FigureAxis axis() const;

  /// The index of a value in values(), which is the position of the value's cell in a map with
  /// cells of equal width.
  std::size_t cell_index(const base::Value& value) const;
  /// The axis of cells with equal widths.
  report::FigureAxis cell_axis() const;

 private:
  std::string key_, label_;
  bool is_words_ = false, is_logarithmic_ = false, is_even_ = false;
  std::vector<base::Value> values_;
};

}  // namespace fpkcheck::sweep
