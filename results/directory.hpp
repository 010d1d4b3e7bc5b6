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

/// Directories that were made for results. Those that nothing was put into go with their owner.
class MadeDirectories {
 public:
  MadeDirectories() = default;
  /// @param made outermost first
  explicit MadeDirectories(std::vector<std::filesystem::path> made) : made_(std::move(made)) {}
  MadeDirectories(MadeDirectories&& other) noexcept : made_(std::exchange(other.made_, {})) {}
  MadeDirectories& operator=(MadeDirectories&& other) noexcept {
    std::swap(made_, other.made_);
    return *this;
  }
  ~MadeDirectories();

 private:
  std::vector<std::filesystem::path> made_;
};

/// Creates the directory with its parents, proves that files can be written in it and in figures/
/// below it, finishes or removes what a stopped run may have left half done there. What it created
/// it removes again when that fails.
/// @return what it created
/// @throws InputError on one line
[[nodiscard]] MadeDirectories make_writable(const std::filesystem::path& directory);

}  // namespace fpkcheck::results
