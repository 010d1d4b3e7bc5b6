#pragma once

#include <chrono>

#include "compare/run_cases.hpp"

namespace fpkcheck::cli {

/// One line on standard error that is rewritten as a run proceeds; silent when standard error is
/// not a terminal or when told to be.
class ProgressLine {
 public:
  explicit ProgressLine(bool silent);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const compare::RunProgress& progress);
  /// Erases the line, so that results begin on a clean one.
  void clear();

 private:
  bool shown_ = false;
  bool active_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace fpkcheck::cli
