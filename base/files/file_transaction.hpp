#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/atomic_file.hpp"

namespace fpkcheck::base {

/// Replaces several files of one directory in one transaction. The function add() writes a partial
/// file beside each target file, and commit() replaces all target files. Without a call of
/// commit(), the destructor removes the partial files and leaves the target files unchanged. If the
/// process is killed, the directory contains either all old or all new files (see
/// FileChangeJournal).
class FileTransaction {
 public:
  using FileWriter = std::function<void(const std::filesystem::path& temporary)>;

  FileTransaction() = default;
  FileTransaction(const FileTransaction&) = delete;
  FileTransaction& operator=(const FileTransaction&) = delete;
  ~FileTransaction();

  /// Calls `produce` to write the partial file of a target file.
  /// @param target path in the same directory as all other targets of the transaction
  /// @throws the exceptions of `produce`
  void add(const std::filesystem::path& target, const FileWriter& produce);
  /// Writes `bytes` to the partial file of a target file.
  /// @throws std::runtime_error with a one-line message
  void add(const std::filesystem::path& target, std::string_view bytes);
  /// Marks a file, which may be absent, for removal by commit().
  void remove(const std::filesystem::path& target);

  /// Replaces all target files by their partial files, and removes the files marked for removal.
  /// @throws std::runtime_error with a one-line message. A missing partial file, or a directory
  /// with the name of a target, is detected before any target file is replaced.
  /// @pre commit() was not called before for the transaction
  void commit();

 private:
  struct Pending {
    std::filesystem::path temporary, target;
  };
  void require_target_in_same_directory(const std::filesystem::path& target) const;
  void replace_target_files(const std::filesystem::path& directory);

  std::vector<Pending> pending_;
  std::vector<std::filesystem::path> removals_;
  bool committed_ = false;
};

/// Calls `produce` to write a temporary file in the directory of the target file, then renames the
/// file to the target. If `produce` fails, the target file is unchanged and the temporary file is
/// removed.
/// @throws any exception of `produce`; std::runtime_error with a one-line message if `produce`
/// wrote no file
void replace_file_atomically(const std::filesystem::path& target,
                             const FileTransaction::FileWriter& produce);

/// Atomically replaces the contents of a file by `bytes`.
/// @throws std::runtime_error with a one-line message
void write_file_atomically(const std::filesystem::path& target, std::string_view bytes);

/// Write-ahead journal of a change of several files in one directory. The journal is written before
/// the first file is replaced and is removed after the last file is replaced. If a process is
/// killed before all files are replaced, the next process replaces the remaining files.
struct FileChangeJournal {
  struct FileRename {
    std::string from, to;
  };

  WriterProcess writer = WriterProcess::current_process();
  std::vector<FileRename> renames{};
  std::vector<std::string> removals{};  ///< names of files to remove; absent files are allowed

  static constexpr const char* kFileName = ".fpkcheck-commit";

  /// Writes the journal to disk. If this process is killed after write_to_directory(), a later
  /// process completes the change of files.
  /// @throws std::system_error if no journal was written; the error code is file_exists if the
  /// directory already contains a journal
  void write_to_directory(const std::filesystem::path& directory) const;
  /// Performs the remaining renames and removals of the journal, then removes the journal.
  /// @throws std::system_error if a rename or removal fails; the journal of file changes then
  /// remains in the directory
  void apply_file_changes(const std::filesystem::path& directory) const;
};

/// If the directory contains a journal, completes the change of files that a killed process left
/// incomplete.
/// @throws InputError with a one-line message if another process may still apply the journal, if
/// the journal is damaged or belongs to another user, or if the directory is not writable
void recover_interrupted_commit(const std::filesystem::path& directory);

}  // namespace fpkcheck::base
