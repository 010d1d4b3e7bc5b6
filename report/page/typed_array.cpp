#include "report/page/typed_array.hpp"

#include <algorithm>
#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <vector>

namespace fpkcheck::report {
namespace {

static_assert(std::endian::native == std::endian::little, "plotly.js reads little-endian numbers");

std::string base64(std::span<const std::byte> bytes) {
  namespace it = boost::archive::iterators;
  using Encoder = it::base64_from_binary<it::transform_width<const char*, 6, 8>>;
  // The iterators read whole groups of three bytes.
  std::vector<char> padded((bytes.size() + 2) / 3 * 3, 0);
  std::ranges::transform(bytes, padded.begin(), [](std::byte b) { return static_cast<char>(b); });
  std::string text(Encoder(padded.data()), Encoder(padded.data() + padded.size()));
  const std::size_t padding = padded.size() - bytes.size();
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

}  // namespace

TypedArray float_array(std::span<const double> values) {
  const std::vector<float> rounded(values.begin(), values.end());
  return {"f4", base64(std::as_bytes(std::span(rounded)))};
}

TypedArray integer_array(std::span<const std::int16_t> values) {
  return {"i2", base64(std::as_bytes(values))};
}

}  // namespace fpkcheck::report
