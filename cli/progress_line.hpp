#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "methods/run_cases.hpp"

namespace fpkcheck::cli {

/// Where a run stands, in words: how many solutions are done, the time so far, the method at work
/// with its share done and, once that can be told, the time it has left.
/// @param seconds since the run began
/// @param method_seconds since this method began on this case
std::string progress_text(const methods::RunProgress& progress, double seconds,
                          double method_seconds);

/// Whether standard error is a terminal that takes control sequences (TERM is not `dumb`).
bool can_rewrite_a_line();

/// One line on standard error that is rewritten as a run proceeds; silent where can_rewrite_a_line()
/// is false or when told to be.
class ProgressLine {
 public:
  explicit ProgressLine(bool silent);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @throws Interrupted (interruption.hpp), silent or not
  void show(const methods::RunProgress& progress);
  /// Erases the line, so that results begin on a clean one.
  void clear();

 private:
  bool shown_ = false;
  bool active_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  /// When a method began on a case: several run side by side.
  std::map<std::pair<std::string, std::string>, std::chrono::steady_clock::time_point> began_;
};

}  // namespace fpkcheck::cli
