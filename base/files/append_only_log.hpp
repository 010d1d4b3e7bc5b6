#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/atomic_file.hpp"

namespace fpkcheck::base {

/// An append-only text file with an exclusive lock: only one process at a time writes the file. A
/// killed process leaves at most one incomplete last line. The next process removes this incomplete
/// line in read_lines().
class AppendOnlyLog {
 public:
  /// Opens and locks the file, which is created if missing.
  /// @throws InputError with a one-line message if another process has locked the file or if the
  /// file is not a regular file; std::runtime_error if the file cannot be opened
  explicit AppendOnlyLog(const std::filesystem::path& file);

  /// Reads the existing lines, without line ends, and removes an incomplete last line from the
  /// file. The function read_lines() must be called once, before append().
  /// @throws std::runtime_error with a one-line message
  std::vector<std::string> read_lines();
  bool has_removed_partial_line() const { return removed_partial_line_; }

  /// Appends a line completely, or leaves the file unchanged. An appended line remains in the file
  /// even if the process is killed.
  /// @throws std::runtime_error with a one-line message if the line cannot be written
  void append(std::string_view line);
  /// Waits until all appended lines are on disk and would survive a power failure.
  void flush_to_disk() const;

 private:
  [[noreturn]] void throw_error(const char* what) const;

  std::filesystem::path file_;
  FileDescriptor descriptor_;
  long long length_ = 0;
  bool removed_partial_line_ = false;
};

}  // namespace fpkcheck::base
