#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace fpkcheck::base {

/// Files that are replaced as one transaction. Each is written beside its target; commit() replaces
/// all targets. A process that is killed leaves all old or all new files (Journal). Without
/// commit() the targets are unchanged and the partial files are removed.
class PendingFiles {
 public:
  /// Writes a file under a temporary name in the target's directory.
  using FileProducer = std::function<void(const std::filesystem::path& temporary)>;

  PendingFiles() = default;
  PendingFiles(const PendingFiles&) = delete;
  PendingFiles& operator=(const PendingFiles&) = delete;
  ~PendingFiles();

  /// Writes a partial file for the target.
  /// @param target in the same directory as all previous targets
  /// @throws whatever `produce` throws
  void add(const std::filesystem::path& target, const FileProducer& produce);
  /// Writes a partial file with these bytes.
  /// @throws std::runtime_error on one line
  void add(const std::filesystem::path& target, std::string_view bytes);
  /// Marks a file for removal: commit() removes it if it exists.
  void remove(const std::filesystem::path& target);

  /// Replaces all targets.
  /// @throws std::runtime_error on one line, before any target is touched, when a file was not
  /// produced or a directory has the name of a target
  void commit();

 private:
  struct Pending {
    std::filesystem::path temporary, target;
  };
  void require_one_directory(const std::filesystem::path& target) const;
  void install_files(const std::filesystem::path& directory);

  std::vector<Pending> pending_;
  std::vector<std::filesystem::path> removals_;
};

/// Lets `produce` write a temporary file in the target's directory, then renames it to the target.
/// On failure the target is unchanged and the temporary file is removed.
/// @throws whatever `produce` throws; std::runtime_error on one line when it wrote no file
void replace_file(const std::filesystem::path& target, const PendingFiles::FileProducer& produce);

/// Replaces a file by one with these bytes.
/// @throws std::runtime_error on one line
void write_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace fpkcheck::base
