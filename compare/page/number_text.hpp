#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

/// Numbers and words of summary.json as the page shows them; a dash for what is absent.
namespace fpkcheck::compare {

/// With this many significant digits: 0.3945, 1.2e-5.
std::string number_text(const std::optional<double>& value, int digits);

/// Of a seconds field: 0.0042, 0.21, 16.9, 130.
std::string seconds_text(const std::optional<double>& seconds);

/// The text under a key.
std::string word(const nlohmann::ordered_json& object, std::string_view key);

}  // namespace fpkcheck::compare
