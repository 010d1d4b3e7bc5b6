#include "methods/external/external_argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>

#include "base/input_error.hpp"
#include "base/options/enum_names.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::methods {
namespace {

namespace fs = std::filesystem;

bool file_exists(const std::string& text) {
  std::error_code ignored;
  return fs::exists(text, ignored);
}

int parse_order(const std::string& value) {
  constexpr int kMaxOrder = 99;
  const auto order = base::parse_number<int>(value);
  if (order && *order >= 1 && *order <= kMaxOrder) return *order;
  throw InputError(fmt::format("--against: order = {} (must be an integer, 1 .. {})",
                               base::in_quotes(value), kMaxOrder));
}

void set(const std::string& key, const std::string& value, ExternalDensityArgument& argument) {
  if (key == "equation") {
    argument.equation = base::parse_enum<problem::DensityEquation>("--against: equation =", value);
  } else if (key == "impact") {
    argument.impact = base::parse_enum<problem::ImpactCondition>("--against: impact =", value);
  } else if (key == "order") {
    argument.order = parse_order(value);
  } else if (key == "samples") {
    argument.samples = base::parse_enum<SampleRelation>("--against: samples =", value);
  } else if (key == "role") {
    if (value != "reference") {
      throw InputError(
          fmt::format("--against: role = {} (must be reference)", base::in_quotes(value)));
    }
    argument.is_reference = true;
  } else if (key == "solution") {
    argument.solution = value;
  } else if (key == "case") {
    argument.case_name = value;
  } else {
    throw InputError(
        fmt::format("--against: unknown key {}; use equation, impact, order, samples, role, "
                    "solution or case",
                    base::in_quotes(key)));
  }
}

// Returns the position of the comma of the last ",KEY=VALUE" in an argument, or npos.
std::size_t last_setting_position(const std::string& text) {
  const auto comma = text.rfind(',');
  if (comma == std::string::npos) return comma;
  const auto equals = text.find('=', comma);
  if (equals == std::string::npos || equals == comma + 1) return std::string::npos;
  const bool word =
      std::all_of(text.begin() + static_cast<std::ptrdiff_t>(comma) + 1,
                  text.begin() + static_cast<std::ptrdiff_t>(equals),
                  [](unsigned char c) { return std::islower(c) != 0 || c == '_' || c == '-'; });
  return word ? comma : std::string::npos;
}

}  // namespace

ExternalDensityArgument parse_external_argument(const std::string& text) {
  ExternalDensityArgument argument;
  std::string rest = text;
  while (!file_exists(rest)) {
    const auto comma = last_setting_position(rest), colon = rest.rfind(':');
    if (comma == std::string::npos) break;
    const bool is_in_file_name = colon != std::string::npos && colon > comma;
    if (is_in_file_name && file_exists(rest.substr(0, colon))) break;
    const auto equals = rest.find('=', comma);
    set(rest.substr(comma + 1, equals - comma - 1), rest.substr(equals + 1), argument);
    rest.erase(comma);
  }
  if (argument.impact && !argument.equation) {
    throw InputError(
        fmt::format("--against: impact = {} lacks an equation; give both", name(*argument.impact)));
  }
  if (argument.is_reference && argument.equation) {
    throw InputError(
        fmt::format("--against: role = reference with equation = {}; a reference approximates no "
                    "equation, omit one key",
                    name(*argument.equation)));
  }
  const auto colon = rest.rfind(':');
  if (colon == std::string::npos || file_exists(rest)) {
    argument.file = rest;
    argument.label = results::case_file_stem(argument.file.stem().string());
    argument.has_label = false;
  } else {
    argument.file = rest.substr(0, colon);
    argument.label = rest.substr(colon + 1);
  }
  return argument;
}

}  // namespace fpkcheck::methods
