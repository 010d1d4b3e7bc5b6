#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "workflows/sweep/execution/cost_model.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// How points are given to workers.
enum class Dispatch {
  longest_first,  ///< to whoever is free, the longest expected first
  in_order,       ///< to whoever is free, as they come
  shards          ///< every N-th to each, beforehand
};

/// The time until the last worker is done, when points take so long.
/// @param seconds of each point
double makespan(std::span<const double> seconds, std::size_t workers, Dispatch dispatch);

/// What a plan will take, told from a sample of its points.
struct Forecast {
  std::vector<CostModel::Measured> sample{};
  std::vector<double> seconds{};  ///< expected of each point
  double uncertainty = 0;         ///< of their sum: relative standard error
  double megabytes = 0;  ///< largest resident set, with all threads; 0 where nothing was solved
};

/// Solves a sample of a plan by so many threads, and tells the rest from it and from what was solved
/// before. Nothing is written.
/// @param solved before; where these are enough no more is solved
/// @param threads 0 for one per processor
/// @throws whatever a solver throws
Forecast forecast(const Plan& plan, const std::vector<PointResult>& solved, int threads);

}  // namespace fpkcheck::sweep
