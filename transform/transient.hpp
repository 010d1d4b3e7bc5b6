#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/initial_density.hpp"
#include "transform/marginal_density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// Initial density, times and bins for the computation of a density over time.
struct TransientRequest {
  problem::InitialDensityOptions start = {};
  double until = 0;  ///< end time T > 0
  /// Whether to compute the densities of the periodic state, with the period T of the excitation
  bool periodic = false;
  int snapshots = 20;  ///< number N of intervals: densities at the times t = 0, T/N, .., T
  std::vector<double> y_edges = {}, v_edges = {};  ///< edges of the bins, in physical coordinates

  problem::TimeSpan time_span() const { return {until, periodic}; }
  double time_of_snapshot(int snapshot) const {
    return snapshot == snapshots ? until : snapshot * (until / snapshots);
  }
};

/// The probability density at one time, in physical coordinates.
struct TransientDensitySnapshot {
  double time = 0;
  Moments moments = {};
  Marginal y = {}, ydot = {};  ///< averages of p(y, t) and p(y', t) over the bins
  /// Errors of the moments, and L1 errors of the marginal densities: error estimates, or standard
  /// errors and expected sampling errors of a simulation; empty for a method without error
  /// estimates.
  std::optional<ErrorEstimate> error = {};
};

/// The probability density over time, computed by one method.
struct TransientDensities {
  std::string id;  ///< id of the solution, such as "fd-kf" or "epc-polar-n6"
  Status status = Status::failed;
  std::string reason = {};  ///< reason of the status, one sentence; empty only for status ok
  double seconds = 0;
  /// Whether the errors are standard errors of a simulation,
  /// under noise plus an estimate of the error by the interval between noise kicks
  bool has_standard_errors = false;
  std::vector<TransientDensitySnapshot> snapshots =
      {};                    ///< snapshots up to the last time that was reached
  std::string details = {};  ///< grid, order or number of paths, for tables
};

/// Estimates the errors of the snapshots by the differences to less accurate snapshots. The error
/// of a snapshot is the largest difference among the snapshots within half a period before and
/// after, at least among the two neighbouring snapshots. The error is a maximum over several
/// snapshots, since the differences oscillate and a single difference may be 0 by chance.
/// @param less_accurate less accurate snapshots at the same times and with the same bins; the last
/// times may be missing
void estimate_errors_by_differences(const std::vector<TransientDensitySnapshot>& less_accurate,
                                    double half_period,
                                    std::vector<TransientDensitySnapshot>& snapshots);

}  // namespace fpkcheck::transform
