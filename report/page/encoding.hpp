#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

/// Encodings of texts and numbers inside the page: base64, gzip, and the typed arrays of plotly.js.
namespace fpkcheck::report {

/// Base64 encoding of bytes (RFC 4648).
std::string encode_base64(std::span<const std::byte> bytes);

/// Compresses a text by gzip (RFC 1952) and encodes the result in base64; page.js unpacks the
/// result by DecompressionStream. Equal texts give equal results.
/// @throws std::bad_alloc
std::string gzip_base64(std::string_view text);

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
