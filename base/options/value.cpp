#include "base/options/value.hpp"

#include <fmt/format.h>

#include "base/text/sanitise.hpp"

namespace fpkcheck::base {
namespace {

std::string held_text(std::monostate) { return "automatic"; }
std::string held_text(bool value) { return value ? "true" : "false"; }
std::string held_text(std::int64_t value) { return fmt::format("{}", value); }
std::string held_text(double value) { return fmt::format("{}", value); }
std::string held_text(const std::string& value) { return in_quotes(value); }

}  // namespace

std::string text_of(const Value& value) {
  return std::visit([](const auto& held) { return held_text(held); }, value);
}

}  // namespace fpkcheck::base
