#include "report/reasons.hpp"

#include <algorithm>

namespace fpkcheck::report {

std::vector<Reason> reasons(const results::Case& one) {
  std::vector<Reason> all;
  for (const auto& solution : one.solutions) {
    if (solution.is_ok()) continue;
    const auto same = std::ranges::find_if(all, [&](const Reason& reason) {
      return reason.status == transform::Status::not_offered && reason.status == solution.status &&
             reason.text == solution.reason;
    });
    if (same != all.end()) {
      same->solutions.push_back(solution.id());
    } else {
      all.push_back({{solution.id()}, solution.status, solution.reason});
    }
  }
  return all;
}

}  // namespace fpkcheck::report
