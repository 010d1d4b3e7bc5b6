#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Files that are whole or absent: written beside the target first, then renamed.
namespace fpkcheck::base {

/// A hidden name beside the target, of this process alone, so that two runs into one directory do
/// not write into each other's files: .NAME.partial-HOST-PID
std::filesystem::path partial_beside(const std::filesystem::path& target);

/// A process, as names and journals of partial files have it.
struct Writer {
  std::string host;
  long pid;

  static Writer this_one();
  /// Whether it may still run; of another machine that is not known.
  bool may_run() const;
};

/// Removes the partial files in a directory that processes of this machine have left which run no
/// more. Whatever else has such a name stays: it is somebody else's.
void remove_abandoned(const std::filesystem::path& directory);

/// Writes a file that is not there yet, and waits until it is on the disk.
/// @throws std::system_error, and leaves no file
void write_new(const std::filesystem::path& file, std::string_view bytes);

/// Waits until a file, or the names in a directory, are on the disk.
/// @throws std::system_error
void flush(const std::filesystem::path& path);

}  // namespace fpkcheck::base
