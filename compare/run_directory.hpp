#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

/// Writing so that a file is either whole or absent: beside the target first, then renamed.
namespace fpkcheck::compare {

/// Creates the directory with its parents, proves that files can be written in it and in figures/
/// below it, and removes what a stopped run may have left half written there. What it created it
/// removes again when that fails.
/// @throws InputError on one line
void make_writable(const std::filesystem::path& directory);

/// Lets `produce` write a file under a temporary name in the target's directory, then renames it to
/// the target. When anything fails, the target is as it was and the temporary file is gone.
/// @throws whatever `produce` throws; std::runtime_error on one line when it left no file
void replace_file(const std::filesystem::path& target,
                  const std::function<void(const std::filesystem::path& temporary)>& produce);

/// replace_file with this text.
/// @throws std::runtime_error on one line
void write_file(const std::filesystem::path& target, std::string_view text);

}  // namespace fpkcheck::compare
