#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::results {

/// Returns the file name of a case without extension. Each sequence of characters other than
/// letters, digits, '-', '_' and '.' becomes one '_': "case1, r = 0.9" gives "case1_r_0.9".
std::string case_file_stem(const std::string& case_name);

/// Lock on an output directory. While the lock exists, a hidden file prevents other runs from
/// removing the output directory. The destructor of the lock removes the hidden file and those
/// directories in `created` that are empty.
class OutputDirectoryLock {
 public:
  OutputDirectoryLock() = default;
  /// @param lock_file hidden lock file; an empty path if no lock file exists
  /// @param created directories that were created for the output, from the outermost to the
  /// innermost
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

/// Creates an output directory and its parents, and checks that the directory and its subdirectory
/// figures/ are writable. Incomplete files of an interrupted run are completed or removed. Several
/// processes may prepare the same output directory at the same time. After a failure,
/// prepare_output_directory() removes the directories that the same call created.
/// @throws InputError with a message of one line
[[nodiscard]] OutputDirectoryLock prepare_output_directory(const std::filesystem::path& directory);

}  // namespace fpkcheck::results
