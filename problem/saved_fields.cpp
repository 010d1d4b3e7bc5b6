#include "problem/saved_fields.hpp"

#include <fmt/format.h>

#include <utility>

#include "problem/input_error.hpp"

namespace fpkcheck::problem {

using Json = nlohmann::ordered_json;

SavedFields::SavedFields(const Json& object, std::string what)
    : object_(object), what_(std::move(what)) {
  if (!object.is_object()) throw InputError(fmt::format("{} is no JSON object", what_));
}

double SavedFields::number(const std::string& key) {
  const Json& value = at(key);
  if (!value.is_number()) refuse(key, "a number");
  return value.get<double>();
}

std::optional<double> SavedFields::number_or_null(const std::string& key) {
  if (at(key).is_null()) return std::nullopt;
  return number(key);
}

int SavedFields::integer(const std::string& key) {
  const Json& value = at(key);
  const bool fits = value.is_number_unsigned() ? std::in_range<int>(value.get<std::uint64_t>())
                                               : value.is_number_integer() &&
                                                     std::in_range<int>(value.get<std::int64_t>());
  if (!fits) refuse(key, "an integer");
  return value.get<int>();
}

std::optional<int> SavedFields::integer_or_null(const std::string& key) {
  if (at(key).is_null()) return std::nullopt;
  return integer(key);
}

std::uint64_t SavedFields::count(const std::string& key) {
  const Json& value = at(key);
  // What was computed and not parsed may be of the signed kind.
  const bool fits =
      value.is_number_unsigned() || (value.is_number_integer() && value.get<std::int64_t>() >= 0);
  if (!fits) refuse(key, "an integer that is not negative");
  return value.get<std::uint64_t>();
}

bool SavedFields::flag(const std::string& key) {
  const Json& value = at(key);
  if (!value.is_boolean()) refuse(key, "true or false");
  return value.get<bool>();
}

std::string SavedFields::text(const std::string& key) {
  const Json& value = at(key);
  if (!value.is_string()) refuse(key, "a text");
  return value.get<std::string>();
}

void SavedFields::require_all_read() const {
  for (const auto& [key, value] : object_.items()) {
    if (!read_.contains(key)) {
      throw InputError(fmt::format(
          "{}.{} is unknown (of another version of the program? run again)", what_, key));
    }
  }
}

const Json& SavedFields::at(const std::string& key) {
  const auto found = object_.find(key);
  if (found == object_.end()) {
    throw InputError(
        fmt::format("{}.{} is missing (of another version of the program? run again)", what_, key));
  }
  read_.insert(key);
  return *found;
}

void SavedFields::refuse(const std::string& key, std::string_view allowed) const {
  throw InputError(
      fmt::format("{}.{} = {} (must be {})", what_, key, object_.at(key).dump(), allowed));
}

}  // namespace fpkcheck::problem
