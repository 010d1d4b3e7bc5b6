#include "report/page/gzip.hpp"

#include <zlib.h>

#include <new>
#include <span>
#include <vector>

#include "report/page/base64.hpp"

namespace fpkcheck::report {

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

}  // namespace fpkcheck::report
