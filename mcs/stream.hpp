#pragma once

#include <cstdint>

#include "mcs/histogram.hpp"
#include "mcs/plan.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"

namespace fpkcheck::mcs {

/// What one stream saw after its burn-in: averages over its own time.
struct StreamRecord {
  Histogram histogram;
  transform::Moments moments;     ///< over the samples
  double impact_energy_flux = 0;  ///< (sum of v^2 over impacts) / time = int |v|^3 p(0, v) dv
  /// Power that the impulses happened to bring, less its expectation: mean zero.
  double excess_power = 0;
  std::uint64_t impacts = 0;
  std::uint64_t impulses = 0;
};

/// Simulates stream `index` of the plan. Depends on nothing but its arguments.
/// @param plan must outlive the record, whose histogram refers to its bins
StreamRecord run_stream(const problem::Problem& problem, const Plan& plan, std::uint32_t index);

}  // namespace fpkcheck::mcs
