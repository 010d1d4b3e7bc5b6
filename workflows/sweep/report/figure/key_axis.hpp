#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/figure/figure.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"

namespace fpkcheck::sweep {

/// Figure axis of a varied key. The axis of a varied key is logarithmic if the values of the key
/// are spaced logarithmically, and has equidistant categories if the values are words.
class SweepParameterAxis {
 public:
  /// @param axis_index index of the varied key in SweepPlan::axes
  SweepParameterAxis(const SweepPlan& plan, std::size_t axis_index);

  const std::string& key() const { return key_; }
  bool is_categorical() const { return is_words_; }
  bool is_logarithmic() const { return is_logarithmic_; }
  /// Returns the distinct values of the varied key over all sweep points: numbers in increasing
  /// order, words in the order of the plan.
  const std::vector<base::Value>& values() const { return values_; }
  /// Returns the text of a parameter value on an axis, e.g. "0.8" or "gaussian".
  static std::string parameter_value_text(const base::Value& value);

  double coordinate(const base::Value& value) const;
  /// Returns the relative position of a value on the axis of a key: 0 for the first value, 1 for
  /// the last value.
  double relative_figure_coordinate(const base::Value& value) const;
  report::FigureAxis figure_axis() const;

  /// Returns the index of the map cell that belongs to a value of the key, in a map with cells of
  /// equal width.
  std::size_t map_cell_index(const base::Value& value) const;
  report::FigureAxis figure_axis_of_cells() const;

 private:
  std::string key_, label_;
  bool is_words_ = false, is_logarithmic_ = false, is_even_ = false;
  std::vector<base::Value> values_;
};

}  // namespace fpkcheck::sweep
