#pragma once

#include <zlib.h>

#include <algorithm>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace fpkcheck::tests {

/// Inverse of report::gzip_base64.
inline std::string gunzip_base64(std::string base64) {
  namespace it = boost::archive::iterators;
  using Decoder = it::transform_width<it::binary_from_base64<std::string::const_iterator>, 8, 6>;
  const auto padding = std::ranges::count(base64, '=');
  std::ranges::replace(base64, '=', 'A');
  std::string bytes(Decoder(base64.cbegin()), Decoder(base64.cend()));
  bytes.resize(bytes.size() - static_cast<std::size_t>(padding));
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  int result = Z_OK;
  while (result == Z_OK) {
    std::string part(1 << 16, 0);
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    result = inflate(&stream, Z_NO_FLUSH);
    text.append(part, 0, part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("not gzip");
  return text;
}

/// The JSON input of page.js.
inline nlohmann::json plots_in(const std::string& page) {
  const std::string opening = "<script type=\"application/gzip\" id=\"plots\">";
  const auto begin = page.find(opening) + opening.size();
  return nlohmann::json::parse(
      gunzip_base64(page.substr(begin, page.find("</script>", begin) - begin)));
}

}  // namespace fpkcheck::tests
