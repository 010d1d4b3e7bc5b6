#pragma once

#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// The reason why solutions of a case have a status other than `ok`. Solutions with status
/// `not_offered` and equal reasons share one StatusReason.
struct StatusReason {
  std::vector<std::string> solutions;  ///< ids in the order of the case
  transform::Status status;
  std::string text;
};

std::vector<StatusReason> group_status_reasons(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
