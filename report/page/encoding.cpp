#include "report/page/encoding.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <new>
#include <span>
#include <vector>

namespace fpkcheck::report {

std::string encode_base64(std::span<const std::byte> bytes) {
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

std::string gzip_base64(std::string_view text) {
  constexpr int kGzip = 16, kWindowBits = 15, kMemoryLevel = 9;
  z_stream stream{};
  // The only possible error is lack of memory: the parameters are valid and the buffer is large
  // enough.
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWindowBits + kGzip, kMemoryLevel,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  std::vector<std::byte> bytes(deflateBound(&stream, text.size()));
  // zlib does not modify the input.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int result = deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::bad_alloc();
  return encode_base64(bytes);
}

static_assert(std::endian::native == std::endian::little, "plotly.js reads little-endian numbers");

TypedArray float_array(std::span<const double> values) {
  const std::vector<float> rounded(values.begin(), values.end());
  return {"f4", encode_base64(std::as_bytes(std::span(rounded)))};
}

}  // namespace fpkcheck::report
