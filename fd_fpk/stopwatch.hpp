#pragma once

#include <chrono>
#include <limits>

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
  /// Of what there is no answer without.
  static Deadline none() { return Deadline(std::numeric_limits<double>::infinity()); }

  /// Whether what takes so long may begin.
  bool allows(double seconds) const { return stopwatch_.seconds() + seconds <= seconds_; }
  bool is_over() const { return !allows(0); }
  double in_all() const { return seconds_; }

 private:
  Stopwatch stopwatch_;
  double seconds_;
};

}  // namespace fpkcheck::fd_fpk
