#pragma once

#include <string_view>
#include <vector>

#include "methods/external/external_density.hpp"

namespace fpkcheck::methods {

/// Samples of the state (y, y') of the oscillator, or of y alone.
struct StateSamples {
  std::vector<double> y;
  std::vector<double> v;  ///< velocities y', of the same size as y; empty if unknown
  /// Whether successive samples are states of one trajectory at equal time intervals. The sampling
  /// errors of a time series come from a block bootstrap (numerics/block_bootstrap.hpp).
  bool is_time_series = false;
  /// Effective number of independent samples; 0 for the number of samples. A time series determines
  /// its sampling errors by itself.
  double independent = 0;

  std::size_t size() const { return y.size(); }
};

/// Returns a method whose solution is a histogram of samples over the comparison bins, with 95 %
/// confidence intervals and sampling errors. Samples at rest in contact with a wall (y' = 0 at the
/// wall) contribute only to the moments, since the stationary distribution has an atom at the state
/// of rest. The solution of samples of y alone has no density of y'. A time series with fewer than
/// 20 blocks has the status `inaccurate`.
/// @param method transform::kExternalFile or transform::kExternalFunction
/// @throws InputError for fewer than 100 samples, different lengths of y and v, a value that is not
/// finite, or `independent` above the number of samples. Method::check throws InputError for a
/// sample behind a wall.
Method make_method_from_samples(const ExternalDensity& external, std::string_view method,
                                StateSamples samples);

}  // namespace fpkcheck::methods
