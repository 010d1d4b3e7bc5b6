#include "report/status_reasons.hpp"

#include <algorithm>

namespace fpkcheck::report {

std::vector<StatusReason> group_status_reasons(const results::CaseResult& case_result) {
  std::vector<StatusReason> all;
  for (const auto& solution : case_result.solutions) {
    if (solution.is_ok()) continue;
    const auto same = std::ranges::find_if(all, [&](const StatusReason& reason) {
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
