#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace fpkcheck::base {

/// Files that belong together: each is written beside its target, and all replace their targets at
/// once, whatever happens: a process that is killed on the way leaves those of before or all the
/// new ones (Journal). Without commit() the targets stay as they were and the partial files go.
class PendingFiles {
 public:
  /// Writes a file under a temporary name in the target's directory.
  using Produce = std::function<void(const std::filesystem::path& temporary)>;

  PendingFiles() = default;
  PendingFiles(const PendingFiles&) = delete;
  PendingFiles& operator=(const PendingFiles&) = delete;
  ~PendingFiles();

  /// @param target in the directory of those before
  /// @throws whatever `produce` throws
  void add(const std::filesystem::path& target, const Produce& produce);
  /// @throws std::runtime_error on one line
  void add(const std::filesystem::path& target, std::string_view bytes);
  /// The files are not to have this one beside them: commit() removes it where it is.
  void remove(const std::filesystem::path& target);

  /// @throws std::runtime_error on one line, before any target is touched, when a file was not
  ///         produced or a directory stands in its place
  void commit();

 private:
  struct Pending {
    std::filesystem::path temporary, target;
  };
  void require_one_directory(const std::filesystem::path& target) const;
  void put_in_place(const std::filesystem::path& directory);

  std::vector<Pending> pending_;
  std::vector<std::filesystem::path> unwanted_;
};

/// Lets `produce` write a file under a temporary name in the target's directory, then renames it to
/// the target. When anything fails, the target is as it was and the temporary file is gone.
/// @throws whatever `produce` throws; std::runtime_error on one line when it left no file
void replace_file(const std::filesystem::path& target, const PendingFiles::Produce& produce);

/// replace_file with these bytes.
/// @throws std::runtime_error on one line
void write_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace fpkcheck::base
