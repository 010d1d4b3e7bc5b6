#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files/whole_file.hpp"

namespace fpkcheck::base {

/// What is being done to the files of a directory at once. It is written to the disk before the
/// first of them is touched and goes after the last, so that whoever finds it there finishes what
/// a process that was killed has begun: the directory has the files of before, or all the new ones.
struct Journal {
  /// Of a file in the directory.
  struct Rename {
    std::string from, to;
  };

  Writer writer = Writer::this_one();
  std::vector<Rename> renames{};
  std::vector<std::string> removals{};  ///< of files that may not be there

  static constexpr const char* kFile = ".fpkcheck-commit";

  /// Puts the journal into the directory: from now on it will be done.
  /// @throws std::system_error, and leaves none; file_exists where there is another one
  void announce(const std::filesystem::path& directory) const;
  /// Does what is not done yet, and removes the journal.
  /// @throws std::system_error; the journal stays
  void carry_out(const std::filesystem::path& directory) const;
};

/// Finishes what a process has begun that was killed; nothing where there is no journal.
/// @throws InputError on one line where another process may be at it, where the journal is none of
///         ours, or where the directory cannot be written
void finish_interrupted(const std::filesystem::path& directory);

}  // namespace fpkcheck::base
