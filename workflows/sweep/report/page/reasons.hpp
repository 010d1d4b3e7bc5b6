#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Results of a method that are not ok for the same reason, up to numbers in the reason.
struct ReasonGroup {
  std::size_t method;
  transform::Status status;
  std::size_t count = 0;
  std::size_t point = 0;  ///< number of the first point
  std::string reason;     ///< reason at that point
};

/// Groups of reasons, the most frequent first.
std::vector<ReasonGroup> reason_groups(const SweepResults& results);

/// Replaces numbers in a reason: "residual ... after ... steps". Numbers within words ("km4") stay.
std::string without_numbers(const std::string& reason);

}  // namespace fpkcheck::sweep
