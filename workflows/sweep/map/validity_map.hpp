#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transform/solution.hpp"
#include "workflows/sweep/map/map_coordinates.hpp"

namespace fpkcheck::sweep {

/// Result of a method at a point of the map.
struct MappedResult {
  transform::Status status;
  /// L1 distance to the reference, the larger of both marginals; for the reference itself its error
  /// estimate. Empty without a density.
  std::optional<double> l1;
  /// Status `ok`, but L1 exceeds twice the stated error plus the reference's error estimate.
  bool underestimated;
  double seconds;

  bool is_ok() const { return status == transform::Status::ok; }
};

/// A problem that was solved by many methods.
struct MappedPoint {
  MapCoordinates coordinates;
  std::vector<std::optional<MappedResult>>
      method_results;  ///< in the order of ValidityMap::methods; empty: not tried
};

/// Validity map: results of the methods over the parameters (docs/validity.md).
struct ValidityMap {
  std::vector<std::string> methods;  ///< ids; the last one is the reference of every point
  std::vector<MappedPoint> points;
};

/// Reads a map: lines of comma-separated values, the first line with the names of the columns
///
///     impulses_per_decay_time, damping_ratio, cubic_share, restitution, law, mean_share, ID, ..
///
/// and under each id a cell: L1, the letter of the status, and milliseconds. Examples: ".0042o310";
/// "i5.1" without a density; empty where the method was not tried. Letters: o ok, x ok but error
/// underestimated, i inaccurate, a inadmissible, n not_converged, p ill_posed, f failed, u
/// not_offered.
/// @param where name of the map in error messages
/// @throws InputError with a message of one line
ValidityMap read_validity_map(std::string_view text, const std::string& where);

/// The map of this project, workflows/sweep/map/validity.csv, made by scripts/validity.
const ValidityMap& shipped_validity_map();

}  // namespace fpkcheck::sweep
