#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files/atomic_file.hpp"

namespace fpkcheck::base {

/// Write-ahead journal of a change of several files in one directory. The journal is on disk before
/// the first file is replaced and is removed after the last file was replaced. If a process is
/// killed in between, the next process finds the journal and completes the change. The directory
/// therefore ends with either all old files or all new files.
struct Journal {
  /// Renaming of a file within the directory.
  struct FileRename {
    std::string from, to;
  };

  WriterProcess writer = WriterProcess::current_process();
  std::vector<FileRename> renames{};
  std::vector<std::string> removals{};  ///< names of files to remove; absent files are allowed

  static constexpr const char* kFileName = ".fpkcheck-commit";

  /// Writes the journal into the directory. Once the journal is written, this process or a later
  /// process completes the change.
  /// @throws std::system_error, after which no new journal exists; with the code file_exists if the
  /// directory already contains a journal
  void write_to_directory(const std::filesystem::path& directory) const;
  /// Performs those renames and removals that are not yet done, and removes the journal.
  /// @throws std::system_error; the journal then remains
  void apply(const std::filesystem::path& directory) const;
};

/// Completes the change of files that a killed process left incomplete. Does nothing if the
/// directory contains no journal.
/// @throws InputError with a one-line message if another process may still be performing the
/// change, if the journal belongs to another user or is damaged, or if the directory is not
/// writable
void complete_interrupted_commit(const std::filesystem::path& directory);

}  // namespace fpkcheck::base
