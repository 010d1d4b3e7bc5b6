#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::results {

/// The file name, without extension, for a case: the letters, digits, '-', '_' and '.' of its name,
/// with '_' in place of each sequence of other characters. The case "case1, r = 0.9" gives
/// "case1_r_0.9".
std::string file_stem(const std::string& case_name);

/// Lock on an output directory for results. During the lifetime of this object a hidden file in the
/// directory prevents other runs from removing the directory. The destructor removes the hidden
/// file, and the directories in `created` that are empty.
class OutputDirectoryLock {
 public:
  OutputDirectoryLock() = default;
  /// @param lock_file the hidden file; empty if there is none
  /// @param created directories that were created for the output, outermost first
  OutputDirectoryLock(std::filesystem::path lock_file, std::vector<std::filesystem::path> created)
      : lock_file_(std::move(lock_file)), created_(std::move(created)) {}
  OutputDirectoryLock(OutputDirectoryLock&& other) noexcept
      : lock_file_(std::exchange(other.lock_file_, {})),
        created_(std::exchange(other.created_, {})) {}
  OutputDirectoryLock& operator=(OutputDirectoryLock&& other) noexcept {
    std::swap(lock_file_, other.lock_file_);
    std::swap(created_, other.created_);
    return *this;
  }
  ~OutputDirectoryLock();

 private:
  std::filesystem::path lock_file_;
  std::vector<std::filesystem::path> created_;
};

/// Creates an output directory and its parents. Tests that the directory, and an existing
/// subdirectory figures/, are writable. Finishes or removes incomplete files of an interrupted run.
/// Several processes may call this function for the same directory at the same time. On failure,
/// the function removes the directories that it created.
/// @throws InputError with a message of one line
[[nodiscard]] OutputDirectoryLock prepare_output_directory(const std::filesystem::path& directory);

}  // namespace fpkcheck::results
