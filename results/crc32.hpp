#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::results {

/// CRC-32 checksum of the bytes of a file, as eight hexadecimal digits. A run identifies its files
/// by their checksums. The checksum skips carriage returns, since version control may change line
/// ends.
std::string crc32(std::string_view bytes);

}  // namespace fpkcheck::results
