#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Writing so that a file is either whole or absent: beside the target first, then renamed.
namespace fpkcheck::results {

/// The name, without extension, under which something of a case is filed: letters, digits, '-', '_'
/// and '.' of its name, and '_' for everything else.
std::string file_stem(std::string case_name);

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
/// below it, and removes what a stopped run may have left half written there. What it created it
/// removes again when that fails.
/// @return what it created
/// @throws InputError on one line
[[nodiscard]] MadeDirectories make_writable(const std::filesystem::path& directory);

/// Files that belong together: each is written beside its target, and all replace their targets at
/// once. Without commit() the targets stay as they were and the partial files go.
class PendingFiles {
 public:
  /// Writes a file under a temporary name in the target's directory.
  using Produce = std::function<void(const std::filesystem::path& temporary)>;

  PendingFiles() = default;
  PendingFiles(const PendingFiles&) = delete;
  PendingFiles& operator=(const PendingFiles&) = delete;
  ~PendingFiles();

  /// @throws whatever `produce` throws
  void add(const std::filesystem::path& target, const Produce& produce);
  /// @throws std::runtime_error on one line
  void add(const std::filesystem::path& target, std::string_view text);
  /// The files are not to have this one beside them: commit() removes it where it is.
  void remove(const std::filesystem::path& target);

  /// @throws std::runtime_error on one line, before any target is touched, when a file was not
  ///         produced or a directory stands in its place
  void commit();

 private:
  struct Pending {
    std::filesystem::path temporary, target;
  };
  std::vector<Pending> pending_;
  std::vector<std::filesystem::path> unwanted_;
};

/// Lets `produce` write a file under a temporary name in the target's directory, then renames it to
/// the target. When anything fails, the target is as it was and the temporary file is gone.
/// @throws whatever `produce` throws; std::runtime_error on one line when it left no file
void replace_file(const std::filesystem::path& target, const PendingFiles::Produce& produce);

/// replace_file with this text.
/// @throws std::runtime_error on one line
void write_file(const std::filesystem::path& target, std::string_view text);

}  // namespace fpkcheck::results
