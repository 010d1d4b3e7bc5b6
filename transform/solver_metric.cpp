#include "transform/solver_metric.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace fpkcheck::transform {

const SolverMetric* find_metric(const Metrics& metrics, std::string_view path) {
  const auto found = std::ranges::find(metrics, path, &SolverMetric::path);
  return found == metrics.end() ? nullptr : &*found;
}

std::optional<double> metric_number(const Metrics& metrics, std::string_view path) {
  const SolverMetric* found = find_metric(metrics, path);
  if (found == nullptr) return std::nullopt;
  if (const auto* count = std::get_if<std::int64_t>(&found->value)) {
    return static_cast<double>(*count);
  }
  const auto* number = std::get_if<double>(&found->value);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

std::optional<std::string> metric_text(const Metrics& metrics, std::string_view path) {
  const SolverMetric* found = find_metric(metrics, path);
  const auto* word = found == nullptr ? nullptr : std::get_if<std::string>(&found->value);
  return word == nullptr ? std::nullopt : std::optional(*word);
}

SolverMetricsBuilder& SolverMetricsBuilder::add(SolverMetric metric) {
  metrics_.push_back(std::move(metric));
  return *this;
}
SolverMetricsBuilder& SolverMetricsBuilder::add_result_metric(const std::string& path,
                                                              base::Value value) {
  return add({.path = path, .value = std::move(value)});
}
SolverMetricsBuilder& SolverMetricsBuilder::add_diagnostic_metric(const std::string& path,
                                                                  base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = SolverMetricKind::work});
}
SolverMetricsBuilder& SolverMetricsBuilder::add_text_metric(const std::string& path,
                                                            base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = SolverMetricKind::text});
}
SolverMetricsBuilder& SolverMetricsBuilder::add_error_metric(const std::string& path,
                                                             base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = SolverMetricKind::error});
}
SolverMetricsBuilder& SolverMetricsBuilder::add_empty_list(const std::string& path,
                                                           SolverMetricKind kind) {
  return add({.path = path + "[]", .value = {}, .kind = kind});
}

void add_balance_metrics(SolverMetricsBuilder& builder, const BalanceResiduals& residuals,
                         const BalanceResiduals& standard_errors) {
  constexpr std::pair<const char*, std::optional<double> BalanceResiduals::*> kIdentities[] = {
      {"balances.virial", &BalanceResiduals::virial},
      {"balances.momentum", &BalanceResiduals::momentum}};
  for (const auto& [path, identity] : kIdentities) {
    const auto& error = standard_errors.*identity;
    const std::string error_path = std::string(path) + "_error";
    builder.add({.path = path,
                 .value = value_from_optional(residuals.*identity),
                 .kind = SolverMetricKind::work,
                 .standard_error_path = error ? error_path : ""});
    if (error) builder.add_error_metric(error_path, *error);
  }
}

}  // namespace fpkcheck::transform
