#include "base/options/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/input_error.hpp"
#include "base/text/shown.hpp"

namespace fpkcheck::base {
namespace {

constexpr const char* kOtherVersion =
    "the file may be from another version of the program; run again";

[[noreturn]] void refuse(const std::string& label, const std::string& value,
                         const std::string& allowed) {
  throw InputError(fmt::format("{} {} (must be {})", label, value, allowed));
}

}  // namespace

const Parameter* Descriptions::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &Parameter::name);
  return found == all_.end() ? nullptr : &*found;
}

Values Descriptions::values_of(const void* owner) const {
  Values values;
  for (const auto& parameter : all_) values.push_back({parameter.name, parameter.get(owner)});
  return values;
}

Values Descriptions::named_values_of(const void* owner) const {
  Values values;
  for (const auto& parameter : all_) {
    NamedValue one{parameter.name, parameter.get(owner)};
    if (!parameter.silent || one.value != parameter.fallback) values.push_back(std::move(one));
  }
  return values;
}

void Descriptions::read_into(void* owner, const Values& values, const std::string& what) const {
  for (const auto& parameter : all_) {
    const auto found = std::ranges::find(values, parameter.name, &NamedValue::name);
    if (found == values.end() && !parameter.fallback) {
      throw InputError(fmt::format("{}.{} is missing: {}", what, parameter.name, kOtherVersion));
    }
    set(owner, parameter, found == values.end() ? *parameter.fallback : found->value,
        fmt::format("{}.{} =", what, parameter.name));
  }
  for (const auto& [name, value] : values) {
    if (find(name) == nullptr) {
      throw InputError(fmt::format("{}.{} is unknown: {}", what, shown(name), kOtherVersion));
    }
  }
}

void Descriptions::require_ranges(const void* owner) const {
  for (const auto& parameter : all_) {
    const Value value = parameter.get(owner);
    if (parameter.in_range(value)) continue;
    refuse(fmt::format("{}{} =", prefix_, parameter.name), text_of(value), parameter.allowed());
  }
}

void Descriptions::set_parsed(void* owner, const Parameter& parameter, std::string_view text,
                              const std::string& label) const {
  set(owner, parameter, value_from(parameter, text, label), label);
}

void Descriptions::set(void* owner, const Parameter& parameter, const Value& value,
                       const std::string& label) const {
  const auto accepted = parameter.accepted(value);
  if (!accepted) refuse(label, text_of(value), parameter.allowed());
  try {
    parameter.set(owner, *accepted);
  } catch (const std::out_of_range&) {
    refuse(label, text_of(value), parameter.allowed());
  }
}

}  // namespace fpkcheck::base
