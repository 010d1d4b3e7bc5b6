#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/options/value.hpp"

namespace fpkcheck::transform {

/// What an observation is, and with that how a repeated run is held to it.
enum class Kind {
  result,       ///< part of the answer: must come out again
  coefficient,  ///< of a closed form, of which only the whole is determined to the last digits
  error,        ///< what a method says of its own errors by chance
  work,         ///< how the answer came about: steps, iterations, seconds, residuals
  text          ///< words, for people
};

/// Something that one solver alone knows of its solution: a value under a path such as
/// "support.edge_density" or "quantiles.y[2].value", in files as on the page. Whoever writes, checks
/// or shows observations needs no list of any solver's names.
struct Observation {
  std::string path;
  base::Value value;  ///< nothing: there is none
  Kind kind = Kind::result;
  /// Path of the standard error of this value, itself an observation; empty where chance has no
  /// part.
  std::string error_at = {};
  /// A change of a result is judged relative to its size, yet to no less than this.
  double least_scale = 0.1;
  /// Far out in a tail, or a small difference: rounding shows more than elsewhere.
  bool delicate = false;

  bool operator==(const Observation&) const = default;
};

/// Observations in the order in which files show them.
using Observations = std::vector<Observation>;

/// Null when there is none under this path.
const Observation* find(const Observations& observations, std::string_view path);
/// The number under a path; nothing where there is none.
std::optional<double> number(const Observations& observations, std::string_view path);
/// The word under a path; nothing where there is none.
std::optional<std::string> word(const Observations& observations, std::string_view path);

/// Gathers observations one by one.
class Observer {
 public:
  Observer& result(const std::string& path, base::Value value);
  Observer& work(const std::string& path, base::Value value);
  Observer& text(const std::string& path, base::Value value);
  Observer& error(const std::string& path, base::Value value);
  Observer& add(Observation observation);
  /// The list under this path is empty.
  Observer& empty_list(const std::string& path, Kind kind = Kind::result);

  Observations take() { return std::move(observations_); }

 private:
  Observations observations_;
};

/// A count as a value.
template <class Integer>
base::Value counted(Integer count) {
  return static_cast<std::int64_t>(count);
}

/// The number, if there is one, as a value.
inline base::Value value_of(const std::optional<double>& number) {
  return number ? base::Value(*number) : base::Value();
}

}  // namespace fpkcheck::transform
