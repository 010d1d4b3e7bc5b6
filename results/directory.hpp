#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace fpkcheck::results {

/// The name, without extension, under which something of a case is filed: letters, digits, '-', '_'
/// and '.' of its name, and one '_' for whatever stands between them: "case1, r = 0.9" is filed as
/// "case1_r_0.9".
std::string file_stem(const std::string& case_name);

/// A directory that results are to be put into. As long as this lives a hidden file of this process
/// keeps other runs into the same directory from removing it; then that goes, and so do the
/// directories that were made for it and that nothing was put into.
class PreparedDirectory {
 public:
  PreparedDirectory() = default;
  /// @param hold the hidden file; empty where there is none
  /// @param made directories, outermost first
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

/// Creates the directory with its parents, proves that files can be written in it and in figures/
/// below it if that is there, finishes or removes what a stopped run may have left half done. Other
/// runs may do the same at the same time. What it created it removes again when it fails.
/// @throws InputError on one line
[[nodiscard]] PreparedDirectory make_writable(const std::filesystem::path& directory);

}  // namespace fpkcheck::results
