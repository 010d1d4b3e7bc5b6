#pragma once

#include <chrono>
#include <limits>

namespace fpkcheck::base {

/// Measures the time since the construction of the Stopwatch object.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Time limit, measured from the construction of the Deadline object.
class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds) {}
  static Deadline without_time_limit() { return Deadline(std::numeric_limits<double>::infinity()); }

  /// Returns whether a computation of `seconds`, started now, would end before the deadline.
  bool has_time_for(double seconds) const { return stopwatch_.seconds() + seconds <= seconds_; }
  bool has_deadline_passed() const { return !has_time_for(0); }
  double limit_seconds() const { return seconds_; }

 private:
  Stopwatch stopwatch_;
  double seconds_;
};

}  // namespace fpkcheck::base
