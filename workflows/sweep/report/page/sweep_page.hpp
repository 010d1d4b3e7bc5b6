#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

struct EmbeddedPicture {
  std::string caption;
  std::string media_type;  ///< media type of the picture, e.g. "image/svg+xml"
  std::string bytes;
};

/// Returns the self-contained page of a sweep, the contents of report.html.
std::string sweep_page(const SweepResults& results, const std::vector<EmbeddedPicture>& pictures,
                       const std::string& command);

/// Results of one method in a sweep that have a status other than `ok` for the same reason. Reasons
/// for a status that differ only in numbers count as equal.
struct StatusReasonGroup {
  std::size_t method;
  transform::Status status;
  std::size_t count = 0;
  std::size_t point = 0;  ///< number of the first point of the group
  std::string reason;     ///< reason for the status of the result at the first point
};

/// Returns groups of results with equal reasons for their status, the group with the most results
/// first.
std::vector<StatusReasonGroup> status_reason_groups(const SweepResults& results);

/// Replaces numbers in the text of a reason by dots, e.g. "residual ... after ... steps". Digits
/// within words ("km4") are kept.
std::string replace_numbers_by_dots(const std::string& reason);

}  // namespace fpkcheck::sweep
