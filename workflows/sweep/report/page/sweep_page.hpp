#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A drawn figure that is embedded in a page.
struct EmbeddedPicture {
  std::string caption;
  std::string media_type;  ///< e.g. "image/svg+xml"
  std::string bytes;
};

/// The self-contained page of a sweep, the contents of report.html: varied parameters, methods,
/// figures, and the reasons of solutions that are not ok.
/// @param command command line of the sweep
std::string sweep_page(const SweepResults& results, const std::vector<EmbeddedPicture>& pictures,
                       const std::string& command);

/// A group of results of one method that are not ok for the same reason. Reasons that differ only
/// in numbers are the same.
struct ReasonGroup {
  std::size_t method;
  transform::Status status;
  std::size_t count = 0;
  std::size_t point = 0;  ///< number of the first point
  std::string reason;     ///< reason at that point
};

/// The groups of results with the same reason; the most frequent reason comes first.
std::vector<ReasonGroup> reason_groups(const SweepResults& results);

/// Replaces the numbers in a reason by dots: "residual ... after ... steps". Numbers within words
/// ("km4") are not replaced.
std::string replace_numbers(const std::string& reason);

}  // namespace fpkcheck::sweep
