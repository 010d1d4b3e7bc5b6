#pragma once

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

}  // namespace fpkcheck::sweep
