#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "methods/run_cases.hpp"

namespace fpkcheck::cli {

/// The progress of a run as text: number of solutions done, elapsed time, the running method with
/// its fraction done and, above a fraction of 2 %, an estimate of its remaining time.
/// @param seconds since the run began
/// @param method_seconds since this method began on this case
std::string progress_text(const methods::RunProgress& progress, double seconds,
                          double method_seconds);

/// True if standard error is a terminal that accepts control sequences (TERM is not `dumb`).
bool can_rewrite_line();

/// A line on standard error that is rewritten as a run proceeds. Prints nothing if `silent` or if
/// can_rewrite_line() is false.
class ProgressLine {
 public:
  explicit ProgressLine(bool silent);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @throws Interrupted as throw_if_interrupted() does (interruption.hpp), also if silent
  void show(const methods::RunProgress& progress);
  /// Erases the line before results are printed.
  void clear();

 private:
  bool is_visible_ = false;
  bool active_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  /// Start times by case and method: several methods run in parallel.
  std::map<std::pair<std::string, std::string>, std::chrono::steady_clock::time_point> began_;
};

}  // namespace fpkcheck::cli
