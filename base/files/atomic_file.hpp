#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Atomic replacement of files: written beside the target first, then renamed.
namespace fpkcheck::base {

/// Path of the partial file beside the target: .NAME.partial-HOST-PID. The name is hidden and
/// unique to this process, so that two runs into one directory do not write the same file.
std::filesystem::path partial_path(const std::filesystem::path& target);

/// The process that writes a partial file or a journal.
struct WriterProcess {
  std::string host;
  long pid;

  static WriterProcess current_process();
  /// Whether the process may still be running; true for a process of another host.
  bool may_be_running() const;
};

/// Removes the partial files in a directory whose process ran on this host and has ended. All other
/// files of such a name stay.
void remove_abandoned_partials(const std::filesystem::path& directory);

/// Permissions of a new file, which the umask reduces.
inline constexpr int kFileMode = 0666;

/// Creates a file and waits until it is on disk.
/// @throws std::system_error when the file exists or cannot be written, leaving no partial file
void write_new_file(const std::filesystem::path& file, std::string_view bytes);

/// Waits until a file, or the entries of a directory, are on disk.
/// @throws std::system_error
void flush(const std::filesystem::path& path);

}  // namespace fpkcheck::base
