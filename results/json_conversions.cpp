#include "results/json_conversions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <istream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::results {
namespace {

using transform::Metrics;
using transform::SolverMetric;
using transform::SolverMetricKind;

// Largest accepted nesting depth of JSON. JSON files of the program have a smaller nesting depth,
// and the stack suffices for a far larger nesting depth.
constexpr int kMaxDepth = 32;
// Largest accepted number of JSON values. JSON files of hundreds of cases have fewer values than
// kMaxJsonValues, and the memory suffices for far more values.
constexpr std::size_t kMaxJsonValues = 2'000'000;
// Largest accepted length of a text in JSON, which suffices for a very long command line.
constexpr std::size_t kMaxTextLength = 1 << 20;

// Returns the JSON value at a path, and creates missing objects and lists along the path.
Json& resolve_path(Json& object, std::string_view path) {
  Json* at = &object;
  while (!path.empty()) {
    if (path.front() == '.') path.remove_prefix(1);
    if (at->is_primitive() && !at->is_null()) {
      throw std::logic_error("metric path " + std::string(path) + " leads through a value");
    }
    if (path.front() == '[') {
      const auto close = path.find(']');
      std::size_t index = 0;
      std::from_chars(path.data() + 1, path.data() + close, index);
      at = &(*at)[index];
      path.remove_prefix(close + 1);
    } else {
      const auto end = path.find_first_of(".[");
      at = &(*at)[std::string(path.substr(0, end))];
      path.remove_prefix(std::min(end, path.size()));
    }
  }
  return *at;
}

// Refuses a JSON key that contains a separator of metric paths, since resolve_path() would split
// such a key.
void require_valid_key(const std::string& key) {
  if (!key.empty() && key.find_first_of(".[]") == key.npos) return;
  throw InputError(fmt::format("key {} (must not be empty or contain dots or brackets); run again",
                               base::in_quotes(key)));
}

void collect_metrics(const std::string& path, const Json& json, Metrics& metrics) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      require_valid_key(key);
      collect_metrics(path.empty() ? key : path + '.' + key, value, metrics);
    }
  } else if (json.is_array()) {
    if (json.empty()) metrics.push_back({.path = path + "[]", .value = {}});
    for (std::size_t k = 0; k < json.size(); ++k) {
      collect_metrics(fmt::format("{}[{}]", path, k), json[k], metrics);
    }
  } else {
    metrics.push_back(
        {.path = path,
         .value = value_from_json(json),
         .kind = json.is_string() ? SolverMetricKind::text : SolverMetricKind::result});
  }
}

}  // namespace

Json program_to_json(const ProgramInfo& program) {
  return {{"name", program.name}, {"version", program.version}, {"command", program.command}};
}

Json problem_to_json(const problem::Problem& problem) {
  Json json{{"name", problem.name}};
  for (const auto& section : problem::case_file_sections(problem)) {
    json[section.name] = values_to_json(section.values);
  }
  if (problem.impulses.is_acting()) {
    json["impulse"]["moments"] = problem.impulses.amplitude_law().moments();
  }
  return json;
}

Json value_to_json(const base::Value& value) {
  return std::visit(
      [](const auto& held) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
          return nullptr;
        } else {
          return held;
        }
      },
      value);
}

Json values_to_json(const base::Values& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = value_to_json(value);
  return json;
}

Json number_or_null_json(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

Json moments_to_json(const transform::Moments& m) {
  Json json;
  for (const auto& [name, symbol, moment, size] : transform::kMoments) json[name] = m.*moment;
  return json;
}

void add_metrics(const Metrics& metrics, Json& object) {
  for (const auto& observation : metrics) {
    const std::string_view path = observation.path;
    if (path.ends_with("[]")) {
      resolve_path(object, path.substr(0, path.size() - 2)) = Json::array();
      continue;
    }
    Json& at = resolve_path(object, path);
    if (!at.is_null()) throw std::logic_error("two metrics with the path " + observation.path);
    at = value_to_json(observation.value);
  }
}

Metrics metrics_from_json(const Json& object) {
  Metrics metrics;
  collect_metrics("", object, metrics);
  return metrics;
}

base::Value value_from_json(const Json& json) {
  if (json.is_null()) return {};
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_unsigned() && !std::in_range<std::int64_t>(json.get<std::uint64_t>())) {
    throw InputError(fmt::format("{} exceeds the range of integers; run again",
                                 base::to_printable_text(json.dump())));
  }
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  throw InputError("a list or an object in place of a value; run again");
}

base::Values values_from_json(const Json& object) {
  base::Values values;
  for (const auto& [key, value] : object.items()) {
    if (!value.is_structured()) values.push_back({key, value_from_json(value)});
  }
  return values;
}

problem::Problem problem_from_json(const Json& object) {
  std::vector<problem::CaseFileSection> sections;
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) sections.push_back({key, values_from_json(value)});
  }
  return problem::problem_from_sections(object.at("name").get<std::string>(), sections);
}

double number_at_key(const Json& object, const char* key) {
  const Json& value = object.at(key);
  return value.is_null() ? kNotANumber : value.get<double>();
}

int integer_at_key(const Json& object, const char* key) {
  // The function get<int>() of the JSON library is not used, since get<int>() would silently
  // convert 1e300 and integers out of range.
  const base::Value value = value_from_json(object.at(key));
  const auto* whole = std::get_if<std::int64_t>(&value);
  if (whole == nullptr || !std::in_range<int>(*whole)) {
    throw InputError(fmt::format("\"{}\" is {} (must be an integer); run again", key,
                                 base::value_as_text(value)));
  }
  return static_cast<int>(*whole);
}

transform::Moments moments_from_json(const Json& json) {
  transform::Moments moments;
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    moments.*moment = number_at_key(json, name);
  }
  return moments;
}

std::optional<double> optional_number_at_key(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return std::nullopt;
  return found->get<double>();
}

Json replace_non_finite_by_null(Json value) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return nullptr;
  if (value.is_structured()) {
    for (auto& element : value) element = replace_non_finite_by_null(std::move(element));
  }
  return value;
}

std::string serialise_json(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Json parse_json(std::istream& in, const std::string& file_name) {
  std::size_t count = 0;
  const auto accept_event = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > kMaxDepth) {
      throw InputError(fmt::format("{} is nested more than {} deep: not a file of this program",
                                   file_name, kMaxDepth));
    }
    if (++count > kMaxJsonValues) {
      throw InputError(fmt::format("{} has more than {} values: not a file of this program",
                                   file_name, kMaxJsonValues));
    }
    // Texts are sanitised, since a terminal would execute control characters in a printed text.
    const bool text = event == Json::parse_event_t::key || event == Json::parse_event_t::value;
    if (text && value.is_string()) {
      auto& text_value = value.get_ref<std::string&>();
      if (text_value.size() > kMaxTextLength) {
        throw InputError(fmt::format("{} has a text of {} bytes: not a file of this program",
                                     file_name, text_value.size()));
      }
      text_value = base::escape_control_characters(text_value);
    }
    return true;
  };
  const auto not_json = [&](const std::string& cause) {
    return InputError(fmt::format(
        "{} is not JSON: {}; give a file that fpkcheck wrote, or run again", file_name, cause));
  };
  try {
    return Json::parse(in, accept_event);
  } catch (const Json::parse_error& error) {
    throw not_json(fmt::format("error at byte {}", error.byte));
  } catch (const Json::exception& error) {  // a number is out of the range of double
    throw not_json(json_error_message(error));
  }
}

std::string json_error_message(const std::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return base::to_printable_text(end == std::string::npos ? text : text.substr(end + 2));
}

bool is_run_summary(const std::string& text, const std::string& file_name) {
  std::istringstream in(text);
  const Json json = parse_json(in, file_name);
  return json.is_object() && json.contains("schema");
}

transform::Metrics metrics_from_external_json(const std::string& text,
                                              const std::string& file_name) {
  std::istringstream in(text);
  const Json json = parse_json(in, file_name);
  if (!json.is_object()) throw InputError(fmt::format("{} contains no JSON object", file_name));
  try {
    return metrics_from_json(json);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file_name, error.what()));
  }
}

}  // namespace fpkcheck::results
