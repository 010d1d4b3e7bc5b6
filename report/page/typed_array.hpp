#pragma once

#include <span>
#include <string>

namespace fpkcheck::report {

/// An array of numbers in the JSON format of plotly.js: little-endian bytes in base64.
struct TypedArray {
  std::string dtype;
  std::string bdata;
};

/// Converts numbers to an array of 32-bit floating-point numbers, which keep seven digits in a
/// third of the characters of decimal text.
TypedArray float_array(std::span<const double> values);

/// The conversion to JSON that nlohmann::json calls: {"dtype", "bdata"}.
template <class Json>
void to_json(Json& json, const TypedArray& array) {
  json = {{"dtype", array.dtype}, {"bdata", array.bdata}};
}

}  // namespace fpkcheck::report
