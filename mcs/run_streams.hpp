#pragma once

#include <functional>
#include <vector>

#include "mcs/plan.hpp"
#include "mcs/stream.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// All streams of the plan, in their order. Threads take whole streams, so that nothing depends on
/// how many threads there are.
/// @param progress as Options::progress; may be empty
/// @throws what progress or a stream throws; no further stream is begun then
std::vector<StreamRecord> run_streams(const problem::Problem& problem, const Plan& plan,
                                      const std::function<void(double)>& progress);

/// One number of every stream, in their order.
template <class Of>
std::vector<double> each(const std::vector<StreamRecord>& records, Of of) {
  std::vector<double> values;
  for (const StreamRecord& record : records) values.push_back(of(record));
  return values;
}

}  // namespace fpkcheck::mcs
