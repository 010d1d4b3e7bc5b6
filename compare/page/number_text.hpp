#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

/// Numbers and words of summary.json as the page shows them; a dash for what is absent.
namespace fpkcheck::compare {

/// With exactly this many significant digits, zeros too: 0.4450, 1.2e-5. A single digit, that of
/// residuals, always has its power of ten: 4e-4.
std::string number_text(const std::optional<double>& value, int digits);

/// A count, or a number that was given: with the digits it has, at most six.
std::string plain_text(const std::optional<double>& value);

/// An L1 distance, as the terminal shows it: 0.00437, 6e-6.
std::string l1_cell(const std::optional<double>& l1);

/// Of a seconds field: 0.0042, 0.21, 16.9, 130.
std::string seconds_text(const std::optional<double>& seconds);

/// The text under a key.
std::string word(const nlohmann::ordered_json& object, std::string_view key);

}  // namespace fpkcheck::compare
