#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace fpkcheck::base {

/// Reads a file that a user named. Returns nothing if the file is not a readable regular file:
/// reading a pipe or a device could block the program or never end.
/// @param max_bytes largest accepted number of bytes
/// @throws InputError with a one-line message if the file has more than `max_bytes` bytes
std::optional<std::string> read_input_file(const std::filesystem::path& file,
                                           std::size_t max_bytes);

}  // namespace fpkcheck::base
