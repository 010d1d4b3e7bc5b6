#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// A varied key as an axis of pictures: numbers as they are, on a logarithmic axis where they are
/// spaced so; words one after another.
class KeyAxis {
 public:
  /// @param place of the key among the plan's axes
  KeyAxis(const Plan& plan, std::size_t place);

  const std::string& key() const { return key_; }
  bool is_words() const { return is_words_; }
  bool is_logarithmic() const { return is_logarithmic_; }
  /// The values that points have, each once: numbers by size, words as they are listed.
  const std::vector<base::Value>& values() const { return values_; }
  /// "0.8", "gaussian"
  static std::string text_of(const base::Value& value);

  /// Where a value stands on a gnuplot axis.
  double at(const base::Value& value) const;
  /// How far it is from the first of values() to the last on that axis, 0 .. 1.
  double part(const base::Value& value) const;
  /// Label, scale, range and tics of that axis.
  /// @param letter of the axis: 'x' or 'y'
  std::string commands(char letter) const;

  /// Its label alone, of either axis.
  std::string label_command(char letter) const;

  /// Which of values() it is: where its cell stands in a map, whose cells are all equally wide.
  std::size_t cell_of(const base::Value& value) const;
  /// Label, range and tics of an axis of such cells.
  std::string cell_commands(char letter) const;

 private:
  std::string key_, label_;
  bool is_words_ = false, is_logarithmic_ = false, is_even_ = false;
  std::vector<base::Value> values_;
};

}  // namespace fpkcheck::sweep
