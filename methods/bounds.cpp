#include "methods/bounds.hpp"

#include <chrono>

#include "methods/out_of_memory.hpp"

namespace fpkcheck::methods {

compare::Bounds guaranteed_bounds(const problem::Problem& problem,
                                  const backward::Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  compare::Bounds bounds{.reason = {}, .seconds = 0, .each = {}};
  const bool remembered = unless_out_of_memory([&] {
    const backward::Bounds found = backward::bounds(problem, options);
    bounds.reason = found.reason;
    for (const auto& [functional, value] : found.each) {
      bounds.each.push_back({backward::name(functional), value.lower, value.upper});
    }
  });
  if (!remembered) bounds = {.reason = kOutOfMemory, .seconds = 0, .each = {}};
  bounds.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return bounds;
}

void add_bounds(results::Case& one, int threads) {
  backward::Options options{.relative_half_width = 1e-5, .seconds = 1};
  if (threads > 0) options.threads = threads;
  one.bounds = guaranteed_bounds(one.problem, options);
}

}  // namespace fpkcheck::methods
