#pragma once

#include <string>
#include <string_view>

namespace fpkcheck::results {

/// CRC-32 of a file's bytes as eight hexadecimal digits, by which a run knows its files again.
/// Carriage returns do not count: version control may change the ends of lines.
std::string crc32(std::string_view bytes);

}  // namespace fpkcheck::results
