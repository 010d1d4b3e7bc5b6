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

/// An output directory for results. During the lifetime of this object a hidden file of this
/// process prevents other runs from removing the directory. The destructor removes that file, and
/// those directories that were created for it and are empty.
class PreparedDirectory {
 public:
  PreparedDirectory() = default;
  /// @param lock_file the hidden file; empty where there is none
  /// @param created directories, outermost first
  PreparedDirectory(std::filesystem::path hold, std::vector<std::filesystem::path> made)
      : hold_(std::move(hold)), made_(std::move(made)) {}
  PreparedDirectory(PreparedDirectory&& other) noexcept
      : hold_(std::exchange(other.hold_, {})), made_(std::exchange(other.made_, {})) {}
  PreparedDirectory& operator=(PreparedDirectory&& other) noexcept {
    std::swap(hold_, other.hold_);
    std::swap(made_, other.made_);
    return *this;
  }
  ~PreparedDirectory();

 private:
  std::filesystem::path hold_;
  std::vector<std::filesystem::path> made_;
};

/// Creates the directory with its parents. Tests that the directory, and an existing subdirectory
/// figures/, are writable. Finishes or removes incomplete files of an interrupted run. Other runs
/// may call this function for the same directory at the same time. On failure, removes the
/// directories that it created.
/// @throws InputError on one line
[[nodiscard]] PreparedDirectory make_writable(const std::filesystem::path& directory);

}  // namespace fpkcheck::results
