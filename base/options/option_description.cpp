#include "base/options/option_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::base {
namespace {

constexpr const char* kVersionHint =
    "the file may be from another version of the program; run again";

[[noreturn]] void refuse(const std::string& label, const std::string& value,
                         const std::string& requirement) {
  throw InputError(fmt::format("{} {} (must be {})", label, value, requirement));
}

}  // namespace

const Parameter* OptionsDescriptionBase::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &Parameter::name);
  return found == all_.end() ? nullptr : &*found;
}

Values OptionsDescriptionBase::option_values_of(const void* owner) const {
  Values values;
  for (const auto& parameter : all_) values.push_back({parameter.name, parameter.get(owner)});
  return values;
}

Values OptionsDescriptionBase::stored_option_values_of(const void* owner) const {
  Values values;
  for (const auto& parameter : all_) {
    NamedParameterValue one{parameter.name, parameter.get(owner)};
    if (!parameter.omit_default || one.value != parameter.default_value)
      values.push_back(std::move(one));
  }
  return values;
}

void OptionsDescriptionBase::set_from_values(void* owner, const Values& values,
                                             const std::string& group) const {
  for (const auto& parameter : all_) {
    const auto found = std::ranges::find(values, parameter.name, &NamedParameterValue::name);
    if (found == values.end() && !parameter.default_value) {
      throw InputError(fmt::format("{}.{} is missing: {}", group, parameter.name, kVersionHint));
    }
    set(owner, parameter, found == values.end() ? *parameter.default_value : found->value,
        fmt::format("{}.{} =", group, parameter.name));
  }
  for (const auto& [name, value] : values) {
    if (find(name) == nullptr) {
      throw InputError(
          fmt::format("{}.{} is unknown: {}", group, to_printable_text(name), kVersionHint));
    }
  }
}

void OptionsDescriptionBase::require_values_in_range(const void* owner) const {
  for (const auto& parameter : all_) {
    const Value value = parameter.get(owner);
    if (parameter.is_in_range(value)) continue;
    refuse(fmt::format("{}{} =", prefix_, parameter.name), value_as_text(value),
           parameter.requirement_text());
  }
}

void OptionsDescriptionBase::parse_and_set(void* owner, const Parameter& parameter,
                                           std::string_view text, const std::string& label) const {
  set(owner, parameter, parse_value(parameter, text, label), label);
}

void OptionsDescriptionBase::set(void* owner, const Parameter& parameter, const Value& value,
                                 const std::string& label) const {
  const auto convert_to_parameter_type = parameter.convert_to_parameter_type(value);
  if (!convert_to_parameter_type) refuse(label, value_as_text(value), parameter.requirement_text());
  try {
    parameter.set(owner, *convert_to_parameter_type);
  } catch (const std::out_of_range&) {
    refuse(label, value_as_text(value), parameter.requirement_text());
  }
}

}  // namespace fpkcheck::base
