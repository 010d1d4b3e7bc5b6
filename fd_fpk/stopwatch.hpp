#pragma once

#include <chrono>
#include <limits>

namespace fpkcheck::fd_fpk {

/// Wall-clock time since construction.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// The time limit of a solution, from construction on.
class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds) {}
  /// No time limit.
  static Deadline none() { return Deadline(std::numeric_limits<double>::infinity()); }

  /// True if a task of this duration would end before the deadline.
  bool has_time_for(double seconds) const { return stopwatch_.seconds() + seconds <= seconds_; }
  bool has_passed() const { return !has_time_for(0); }
  double total_seconds() const { return seconds_; }

 private:
  Stopwatch stopwatch_;
  double seconds_;
};

}  // namespace fpkcheck::fd_fpk
