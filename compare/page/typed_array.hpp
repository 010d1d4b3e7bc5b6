#pragma once

#include <nlohmann/json.hpp>
#include <span>

/// Numbers as plotly.js takes them in JSON: {"dtype", "bdata"}, little-endian bytes in base64.
namespace fpkcheck::compare {

/// As 32-bit floating point: seven digits in a third of the characters of a decimal fraction.
nlohmann::ordered_json float_array(std::span<const double> values);

/// As 16-bit integers.
nlohmann::ordered_json integer_array(std::span<const std::int16_t> values);

}  // namespace fpkcheck::compare
