#pragma once

#include <string>

#include "epc/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Reason why the closure does not support a problem, as one phrase. The reason is empty if the
/// closure supports the problem.
std::string unsupported_reason(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc
