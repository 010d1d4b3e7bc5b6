#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/atomic_file.hpp"

namespace fpkcheck::base {

/// Files that are replaced in one transaction. Each new file is first written as a partial file
/// beside its target; commit() then replaces all targets. After a process was killed, the directory
/// has either all old or all new files (Journal). Without a call of commit(), the destructor
/// removes the partial files, and the targets are unchanged.
class PendingFiles {
 public:
  /// Function that writes a file at the given temporary path, which is in the directory of the
  /// target.
  using FileWriter = std::function<void(const std::filesystem::path& temporary)>;

  PendingFiles() = default;
  PendingFiles(const PendingFiles&) = delete;
  PendingFiles& operator=(const PendingFiles&) = delete;
  ~PendingFiles();

  /// Calls `produce` to write the partial file of a target.
  /// @param target path in the same directory as all targets that were added before
  /// @throws whatever `produce` throws
  void add(const std::filesystem::path& target, const FileWriter& produce);
  /// Writes the partial file of a target with these bytes.
  /// @throws std::runtime_error with a one-line message
  void add(const std::filesystem::path& target, std::string_view bytes);
  /// Marks a file for removal. commit() then removes the file if the file exists.
  void remove(const std::filesystem::path& target);

  /// Replaces all targets by their new files, and removes the files that are marked for removal.
  /// @throws std::runtime_error with a one-line message if a partial file does not exist or a
  /// directory has the name of a target; no target is changed before these checks
  /// @pre commit() was not called before
  void commit();

 private:
  struct Pending {
    std::filesystem::path temporary, target;
  };
  void require_same_directory(const std::filesystem::path& target) const;
  void replace_targets(const std::filesystem::path& directory);

  std::vector<Pending> pending_;
  std::vector<std::filesystem::path> removals_;
  bool committed_ = false;
};

/// Calls `produce` to write a temporary file in the directory of the target, then renames the
/// temporary file to the target. If `produce` fails, the target is unchanged and the temporary file
/// is removed.
/// @throws any exception of `produce`; std::runtime_error with a one-line message if `produce`
/// wrote no file
void replace_file(const std::filesystem::path& target, const PendingFiles::FileWriter& produce);

/// Replaces a file by a new file with these bytes.
/// @throws std::runtime_error with a one-line message
void write_file(const std::filesystem::path& target, std::string_view bytes);

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
