#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

/// Atomic replacement of files: the new contents are written to a partial file beside the target,
/// and the partial file is then renamed to the target.
namespace fpkcheck::base {

class FileDescriptor {
 public:
  /// @param number an open file descriptor; a negative number means that the file could not be
  /// opened
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor();

  int descriptor_number() const { return number_; }
  bool is_regular_file() const;
  /// Returns the file descriptor, which the caller must then close.
  int release_descriptor() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// Returns the path .NAME.partial-HOST-PID of the hidden partial file beside a target NAME. Host
/// name and process id in the file name prevent two runs with the same output directory from
/// writing the same partial file.
std::filesystem::path partial_file_path(const std::filesystem::path& target);

struct WriterProcess {
  std::string host;
  long pid;

  static WriterProcess current_process();
  /// Returns false if the process ran on this host and has ended. The state of a process on another
  /// host is unknown, and the function then returns true.
  bool may_be_running() const;
};

/// Removes all partial files of a directory whose writing process ran on this host and has ended.
void remove_abandoned_partial_files(const std::filesystem::path& directory);

/// Permissions of a new file, from which the operating system removes the permissions in the umask.
inline constexpr int kFileMode = 0666;

/// Creates a file with the contents `bytes` and waits until the contents are on disk.
/// @throws std::system_error if the file exists or cannot be written; an incomplete file is removed
void write_new_file(const std::filesystem::path& file, std::string_view bytes);

/// Waits until the contents of a file, or the entries of a directory, are on disk.
/// @throws std::system_error
void flush_to_disk(const std::filesystem::path& path);

}  // namespace fpkcheck::base
