#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// A picture as a page has it.
struct PagePicture {
  std::string caption;
  std::string media_type;  ///< "image/svg+xml"
  std::string bytes;
};

/// report.html of a sweep: one page that needs nothing else. What was varied, the methods, the
/// pictures, and for which reasons answers are not ok.
/// @param command the command line of the sweep
std::string sweep_page(const SweepResults& results, const std::vector<PagePicture>& pictures,
                       const std::string& command);

}  // namespace fpkcheck::sweep
