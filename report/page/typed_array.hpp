#pragma once

#include <span>
#include <string>

namespace fpkcheck::report {

/// Numbers in the JSON format of plotly.js: little-endian bytes in base64.
struct TypedArray {
  std::string dtype;
  std::string bdata;
};

/// Numbers as 32-bit floating point: seven digits in a third of the characters of a decimal
/// fraction.
TypedArray float_array(std::span<const double> values);

/// Conversion for nlohmann::json: {"dtype", "bdata"}.
template <class Json>
void to_json(Json& json, const TypedArray& array) {
  json = {{"dtype", array.dtype}, {"bdata", array.bdata}};
}

}  // namespace fpkcheck::report
