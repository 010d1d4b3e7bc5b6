#include "methods/bounds.hpp"

#include <chrono>

namespace fpkcheck::methods {

compare::Bounds guaranteed_bounds(const problem::Problem& problem, const dual::Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  const dual::Bounds found = dual::bounds(problem, options);
  compare::Bounds bounds{.reason = found.reason, .seconds = 0, .each = {}};
  for (const auto& [functional, value] : found.each) {
    bounds.each.push_back({dual::name(functional), value.lower, value.upper});
  }
  bounds.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return bounds;
}

void add_bounds(std::vector<results::Case>& cases, int threads) {
  for (auto& one : cases) add_bounds(one, threads);
}

void add_bounds(results::Case& one, int threads) {
  dual::Options options{.relative_half_width = 1e-5, .seconds = 1};
  if (threads > 0) options.threads = threads;
  one.bounds = guaranteed_bounds(one.problem, options);
}

}  // namespace fpkcheck::methods
