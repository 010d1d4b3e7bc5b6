#include "report/page/base64.hpp"

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
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

}  // namespace fpkcheck::report
