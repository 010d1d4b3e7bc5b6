#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files/atomic_file.hpp"

namespace fpkcheck::base {

/// Write-ahead journal of a change to several files of one directory. It is on disk before the
/// first file is replaced and removed after the last. A process that finds a journal completes the
/// change of the process that was killed. The directory therefore holds either all old or all new
/// files.
struct Journal {
  /// Renaming of a file within the directory.
  struct Rename {
    std::string from, to;
  };

  WriterProcess writer = WriterProcess::current_process();
  std::vector<Rename> renames{};
  std::vector<std::string> removals{};  ///< names of files to remove; they may be absent

  static constexpr const char* kFileName = ".fpkcheck-commit";

  /// Writes the journal into the directory. From then on the change will be completed.
  /// @throws std::system_error, leaving no journal; file_exists when the directory has one already
  void publish(const std::filesystem::path& directory) const;
  /// Applies the remaining steps and removes the journal.
  /// @throws std::system_error; the journal stays
  void apply(const std::filesystem::path& directory) const;
};

/// Completes the change of a process that was killed; does nothing without a journal.
/// @throws InputError on one line when another process may be working on the change, when the
/// journal belongs to another user or is damaged, or when the directory is not writable
void complete_interrupted_commit(const std::filesystem::path& directory);

}  // namespace fpkcheck::base
