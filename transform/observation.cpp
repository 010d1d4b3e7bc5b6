#include "transform/observation.hpp"

#include <algorithm>
#include <utility>

namespace fpkcheck::transform {

const Observation* find(const Observations& observations, std::string_view path) {
  const auto found = std::ranges::find(observations, path, &Observation::path);
  return found == observations.end() ? nullptr : &*found;
}

std::optional<double> number(const Observations& observations, std::string_view path) {
  const Observation* found = find(observations, path);
  if (found == nullptr) return std::nullopt;
  if (const auto* count = std::get_if<std::int64_t>(&found->value)) {
    return static_cast<double>(*count);
  }
  const auto* number = std::get_if<double>(&found->value);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

std::optional<std::string> word(const Observations& observations, std::string_view path) {
  const Observation* found = find(observations, path);
  const auto* word = found == nullptr ? nullptr : std::get_if<std::string>(&found->value);
  return word == nullptr ? std::nullopt : std::optional(*word);
}

Observer& Observer::add(Observation observation) {
  observations_.push_back(std::move(observation));
  return *this;
}
Observer& Observer::result(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value)});
}
Observer& Observer::work(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = Kind::work});
}
Observer& Observer::text(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = Kind::text});
}
Observer& Observer::error(const std::string& path, base::Value value) {
  return add({.path = path, .value = std::move(value), .kind = Kind::error});
}
Observer& Observer::empty_list(const std::string& path, Kind kind) {
  return add({.path = path + "[]", .value = {}, .kind = kind});
}

}  // namespace fpkcheck::transform
