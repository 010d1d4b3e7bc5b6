#include "transform/metric.hpp"

#include <algorithm>
#include <utility>

namespace fpkcheck::transform {

const Metric* find(const Metrics& metrics, std::string_view path) {
  const auto found = std::ranges::find(metrics, path, &Metric::path);
  return found == metrics.end() ? nullptr : &*found;
}

std::optional<double> number(const Metrics& metrics, std::string_view path) {
  const Metric* found = find(metrics, path);
  if (found == nullptr) return std::nullopt;
  if (const auto* count = std::get_if<std::int64_t>(&found->value)) {
    return static_cast<double>(*count);
  }
  const auto* number = std::get_if<double>(&found->value);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

std::optional<std::string> word(const Metrics& metrics, std::string_view path) {
  const Metric* found = find(metrics, path);
  const auto* word = found == nullptr ? nullptr : std::get_if<std::string>(&found->value);
  return word == nullptr ? std::nullopt : std::optional(*word);
}

MetricBuilder& MetricBuilder::add(Metric observation) {
  metrics_.push_back(std::move(observation));
  return *this;
}
MetricBuilder& MetricBuilder::result(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value)});
}
MetricBuilder& MetricBuilder::work(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = Kind::work});
}
MetricBuilder& MetricBuilder::text(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = Kind::text});
}
MetricBuilder& MetricBuilder::error(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = Kind::error});
}
MetricBuilder& MetricBuilder::add_empty_list(const std::string& path, Kind kind) {
  return add({.path = path + "[]", .value = {}, .kind = kind});
}

}  // namespace fpkcheck::transform
