#include "results/external_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/input_error.hpp"
#include "results/json.hpp"

namespace fpkcheck::results {

bool is_run_summary(const std::string& text, const std::string& where) {
  std::istringstream in(text);
  const Json json = parse_json(in, where);
  return json.is_object() && json.contains("schema");
}

transform::Metrics metrics_from_external_json(const std::string& text, const std::string& where) {
  std::istringstream in(text);
  const Json json = parse_json(in, where);
  if (!json.is_object()) throw InputError(fmt::format("{} contains no JSON object", where));
  try {
    return metrics_from_json(json);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", where, error.what()));
  }
}

}  // namespace fpkcheck::results
