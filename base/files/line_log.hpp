#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fpkcheck::base {

/// A file that grows by whole lines, and that one process at a time writes. A process that is killed
/// leaves at most a last line without its end, which whoever opens the file next cuts off.
class LineLog {
 public:
  /// Opens the file, or makes it.
  /// @throws InputError on one line where another process has it open, or where it is no regular
  ///         file; std::runtime_error where it cannot be opened
  explicit LineLog(const std::filesystem::path& file);
  LineLog(const LineLog&) = delete;
  LineLog& operator=(const LineLog&) = delete;
  ~LineLog();

  /// What was there, without the ends of lines; to be called once.
  /// @throws std::runtime_error on one line
  std::vector<std::string> read();
  /// Whether read() found a line without its end.
  bool cut_off() const { return cut_off_; }

  /// Adds a line, whole or not at all: once this returns, the process may be killed.
  /// @param line without its end
  /// @throws std::runtime_error on one line; the file is as it was
  void append(std::string_view line);
  /// Waits until the file is on the disk: after this the machine may be switched off.
  void flush() const;

 private:
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path file_;
  int descriptor_;
  long long length_ = 0;
  bool cut_off_ = false;
};

}  // namespace fpkcheck::base
