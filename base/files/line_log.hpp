#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::base {

/// An append-only file of lines with an exclusive lock: one process at a time writes it. A killed
/// process leaves at most one incomplete last line, which the next opening removes.
class LineLog {
 public:
  /// Opens and locks the file; creates it if absent.
  /// @throws InputError on one line when another process has locked the file, or when it is not a
  /// regular file; std::runtime_error when it cannot be opened
  explicit LineLog(const std::filesystem::path& file);
  LineLog(const LineLog&) = delete;
  LineLog& operator=(const LineLog&) = delete;
  ~LineLog();

  /// The existing lines, without line ends. Call once, before append().
  /// @throws std::runtime_error on one line
  std::vector<std::string> read();
  /// Whether read() removed an incomplete last line.
  bool removed_partial_line() const { return removed_partial_line_; }

  /// Appends a line, completely or not at all. Once this returns, a killed process does not lose
  /// it.
  /// @param line without its end
  /// @throws std::runtime_error on one line; the file is unchanged
  void append(std::string_view line);
  /// Waits until the data is on disk; afterwards a power failure does not lose it.
  void flush() const;

 private:
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path file_;
  int descriptor_;
  long long length_ = 0;
  bool removed_partial_line_ = false;
};

}  // namespace fpkcheck::base
