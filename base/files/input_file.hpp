#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace fpkcheck::base {

/// The bytes of a file that somebody names; nothing where there is no regular file that can be
/// read: a pipe or a device could keep the program waiting, or never end.
/// @param most how many bytes it may have
/// @throws InputError on one line when it has more
std::optional<std::string> read_input_file(const std::filesystem::path& file, std::size_t most);

}  // namespace fpkcheck::base
