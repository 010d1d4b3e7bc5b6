#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Why solutions of a case are not ok: those to which the same was not offered, together.
struct Reason {
  std::vector<std::string> solutions;  ///< ids, in their order
  transform::Status status;
  std::string text;
};

std::vector<Reason> reasons(const results::Case& one);

}  // namespace fpkcheck::report
