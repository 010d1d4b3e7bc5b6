#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::results {

/// CRC-32 of a file's bytes as eight hexadecimal digits, by which a run identifies its files.
/// Carriage returns are skipped, since version control may change line ends.
std::string crc32(std::string_view bytes);

}  // namespace fpkcheck::results
