#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Answers of a method that are not ok for one reason, whatever numbers it mentions.
struct ReasonGroup {
  std::size_t method;
  transform::Status status;
  std::size_t count = 0;
  std::size_t point = 0;  ///< the first one's number
  std::string reason;     ///< of that point
};

/// The commonest first.
std::vector<ReasonGroup> reason_groups(const SweepResults& results);

/// A reason without its numbers: "residual ... after ... steps"; those within words ("km4") stay.
std::string without_numbers(const std::string& reason);

}  // namespace fpkcheck::sweep
