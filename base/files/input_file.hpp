#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace fpkcheck::base {

/// Reads a file that a user named. Returns nothing unless it is a readable regular file: a pipe or
/// a device could block the program or never end.
/// @param max_bytes largest accepted number of bytes
/// @throws InputError on one line when the file is larger
std::optional<std::string> read_input_file(const std::filesystem::path& file,
                                           std::size_t max_bytes);

}  // namespace fpkcheck::base
