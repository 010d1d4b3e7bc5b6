#include "methods/guaranteed_bounds.hpp"

#include <chrono>

#include "methods/out_of_memory.hpp"

namespace fpkcheck::methods {

compare::GuaranteedBounds guaranteed_bounds(const problem::Problem& problem,
                                            const backward::Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  compare::GuaranteedBounds bounds{.reason = {}, .seconds = 0, .each = {}};
  const bool completed = try_within_memory([&] {
    const backward::GuaranteedBounds computed = backward::compute_bounds(problem, options);
    bounds.reason = computed.reason;
    for (const auto& [functional, value] : computed.each) {
      bounds.each.push_back({backward::name(functional), value.lower, value.upper});
    }
  });
  if (!completed) bounds = {.reason = kOutOfMemory, .seconds = 0, .each = {}};
  bounds.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return bounds;
}

void add_guaranteed_bounds(results::CaseResult& case_result, int thread_count) {
  backward::Options options{.relative_half_width = 1e-5, .seconds = 1};
  if (thread_count > 0) options.threads = thread_count;
  case_result.bounds = guaranteed_bounds(case_result.problem, options);
}

}  // namespace fpkcheck::methods
