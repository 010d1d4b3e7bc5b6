#include "results/crc32.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

namespace fpkcheck::results {

std::string crc32(std::string_view bytes) {
  boost::crc_32_type crc;
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, bytes.find('\r'));
    crc.process_bytes(part.data(), part.size());
    bytes.remove_prefix(std::min(part.size() + 1, bytes.size()));
  }
  return fmt::format("{:08x}", crc.checksum());
}

}  // namespace fpkcheck::results
