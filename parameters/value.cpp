#include "parameters/value.hpp"

#include <fmt/format.h>

namespace fpkcheck::parameters {
namespace {

std::string shown(std::monostate) { return "automatic"; }
std::string shown(bool value) { return value ? "true" : "false"; }
std::string shown(std::int64_t value) { return fmt::format("{}", value); }
std::string shown(double value) { return fmt::format("{}", value); }
std::string shown(const std::string& value) { return fmt::format("'{}'", value); }

}  // namespace

std::string text_of(const Value& value) {
  return std::visit([](const auto& held) { return shown(held); }, value);
}

}  // namespace fpkcheck::parameters
