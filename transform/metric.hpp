#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/options/value.hpp"

namespace fpkcheck::transform {

/// Kind of a metric; it determines how closely a repeated run must reproduce the value.
enum class Kind {
  result,       ///< part of the solution: a repeated run must reproduce it
  coefficient,  ///< of a closed form; single coefficients are not determined to the last digits
  error,        ///< a statistical error estimated by the method
  work,         ///< diagnostics of the computation: steps, iterations, seconds, residuals
  text          ///< text for readers
};

/// A solver-specific quantity of a solution: a value under a path such as "support.edge_density"
/// or "quantiles.y[2].value", the same in files and on the page. Code that writes, checks or
/// prints metrics needs no list of the solvers' names.
struct Metric {
  std::string path;
  base::Value value;  ///< null if the quantity is absent
  Kind kind = Kind::result;
  /// Path of the standard error of this value, itself a metric; empty for a deterministic value.
  std::string standard_error_path = {};
  /// Smallest scale for relative changes of a result: max(|value|, this).
  double min_scale = 0.1;
  /// True for values that amplify rounding errors: far tails and small differences.
  bool is_rounding_sensitive = false;

  bool operator==(const Metric&) const = default;
};

/// Metrics in their order in files.
using Metrics = std::vector<Metric>;

/// The metric with this path, or null.
const Metric* find(const Metrics& metrics, std::string_view path);
/// The number under a path; empty if there is none.
std::optional<double> number(const Metrics& metrics, std::string_view path);
/// The text under a path; empty if there is none.
std::optional<std::string> word(const Metrics& metrics, std::string_view path);

/// Builder of a list of metrics.
class MetricBuilder {
 public:
  MetricBuilder& result(const std::string& path, base::Value value);
  MetricBuilder& work(const std::string& path, base::Value value);
  MetricBuilder& text(const std::string& path, base::Value value);
  MetricBuilder& error(const std::string& path, base::Value value);
  MetricBuilder& add(Metric observation);
  /// Adds an empty list under this path.
  MetricBuilder& add_empty_list(const std::string& path, Kind kind = Kind::result);

  Metrics take() { return std::move(metrics_); }

 private:
  Metrics metrics_;
};

/// Converts a count to a value.
template <class Integer>
base::Value count_value(Integer count) {
  return static_cast<std::int64_t>(count);
}

/// Converts an optional number to a value: null if empty.
inline base::Value optional_value(const std::optional<double>& number) {
  return number ? base::Value(*number) : base::Value();
}

}  // namespace fpkcheck::transform
