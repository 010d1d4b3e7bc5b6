#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/options/parameter_value.hpp"

namespace fpkcheck::transform {

/// Type of a metric, which determines how closely a repeated run must reproduce the value of the
/// metric.
enum class SolverMetricKind {
  result,  ///< part of the solution, which a repeated run must reproduce
  /// Coefficient of a closed form; a repeated run need not reproduce its last digits.
  coefficient,
  error,  ///< statistical error, estimated by the method
  work,   ///< diagnostics of the computation: steps, iterations, seconds, residuals
  text    ///< metric that is an explanatory text
};

/// A quantity of a solution that only one solver returns. The path of a metric, such as
/// "support.edge_density" or "quantiles.y[2].value", is the same in files and on the report page.
/// Code that writes, checks or prints metrics is independent of the solvers.
struct SolverMetric {
  std::string path;
  base::Value value;  ///< value; null if the quantity is absent
  SolverMetricKind kind = SolverMetricKind::result;
  /// Path of the metric that contains the standard error of the present metric; empty for a
  /// deterministic value.
  std::string standard_error_path = {};
  /// Lower limit `min_scale` of the scale max(|value|, min_scale), by which the difference of a
  /// metric between two runs is divided.
  double min_scale = 0.1;
  /// Whether rounding errors strongly change the value of the metric, as in far tails and in small
  /// differences.
  bool is_rounding_sensitive = false;

  bool operator==(const SolverMetric&) const = default;
};

using Metrics = std::vector<SolverMetric>;

const SolverMetric* find_metric(const Metrics& metrics, std::string_view path);
/// Returns the number of the metric with the given path; empty for a path without a number.
std::optional<double> metric_number(const Metrics& metrics, std::string_view path);
/// Returns the text of the metric with the given path; empty for a path without a text.
std::optional<std::string> metric_text(const Metrics& metrics, std::string_view path);

class SolverMetricsBuilder {
 public:
  SolverMetricsBuilder& add_result_metric(const std::string& path, base::Value value);
  SolverMetricsBuilder& add_diagnostic_metric(const std::string& path, base::Value value);
  SolverMetricsBuilder& add_text_metric(const std::string& path, base::Value value);
  SolverMetricsBuilder& add_error_metric(const std::string& path, base::Value value);
  SolverMetricsBuilder& add(SolverMetric metric);
  SolverMetricsBuilder& add_empty_list(const std::string& path,
                                       SolverMetricKind kind = SolverMetricKind::result);

  Metrics take_metrics() { return std::move(metrics_); }

 private:
  Metrics metrics_;
};

template <class Integer>
base::Value value_from_count(Integer count) {
  return static_cast<std::int64_t>(count);
}

/// Converts an optional number to a value; an empty number becomes null.
inline base::Value value_from_optional(const std::optional<double>& number) {
  return number ? base::Value(*number) : base::Value();
}

/// Relative residuals of the virial balance and of the momentum balance (problem/balances.hpp). A
/// balance residual is 0 for the exact stationary density of any density equation and impact
/// condition. A balance residual is empty if the solution lacks a quantity in the balance equation.
/// Balance residuals of 0 do not prove that a density is correct.
struct BalanceResiduals {
  std::optional<double> virial = {};    ///< relative residual of the virial balance
  std::optional<double> momentum = {};  ///< relative residual of the momentum balance
};

/// Adds the residuals of the balance equations as metrics "balances.virial" and
/// "balances.momentum". Standard errors of the residuals, if present, become the metrics
/// "balances.virial_error" and "balances.momentum_error". The balance metrics are diagnostics,
/// which a repeated run need not reproduce.
void add_balance_metrics(SolverMetricsBuilder& builder, const BalanceResiduals& residuals,
                         const BalanceResiduals& standard_errors = {});

}  // namespace fpkcheck::transform
