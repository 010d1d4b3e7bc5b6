#pragma once

#include <chrono>

namespace fpkcheck::fd_fpk {

/// Wall-clock time since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// What is left of the time that a solution may take.
class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds) {}

  /// Whether what takes so long may begin.
  bool allows(double seconds) const { return stopwatch_.seconds() + seconds <= seconds_; }

 private:
  Stopwatch stopwatch_;
  double seconds_;
};

}  // namespace fpkcheck::fd_fpk
