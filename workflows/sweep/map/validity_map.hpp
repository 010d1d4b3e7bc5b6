#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transform/solution.hpp"
#include "workflows/sweep/map/place.hpp"

namespace fpkcheck::sweep {

/// What a method gave at a point of the map.
struct MappedAnswer {
  transform::Status status;
  /// Distance to the reference in L1, the larger one of both marginals; of the reference itself what
  /// it states of its own error. Nothing where there is no density.
  std::optional<double> l1;
  /// `ok`, but further off than twice what it states and what the reference may be off by.
  bool misstated;
  double seconds;

  bool is_ok() const { return status == transform::Status::ok; }
};

/// A problem that was solved by many methods.
struct MappedPoint {
  Place place;
  std::vector<std::optional<MappedAnswer>>
      answers;  ///< as ValidityMap::methods; nothing: not asked
};

/// Where which method holds, as far as it was tried (docs/validity.md).
struct ValidityMap {
  std::vector<std::string> methods;  ///< ids; the last one is the reference of every point
  std::vector<MappedPoint> points;
};

/// Reads a map: lines of commas, the first one with the names of the columns
///
///     impulses_per_decay_time, damping_ratio, cubic_share, restitution, law, mean_share, ID, ..
///
/// and below each id L1, the letter of the status and milliseconds, ".0042o310", "i5.1" without a
/// density, or nothing where the method was not asked. Letters: o ok, x ok but misstated,
/// i inaccurate, a inadmissible, n not_converged, p ill_posed, f failed, u not_offered.
/// @param where how messages name it
/// @throws InputError on one line
ValidityMap read_validity_map(std::string_view text, const std::string& where);

/// The map of this project, workflows/sweep/map/validity.csv, which scripts/validity makes.
const ValidityMap& shipped_validity_map();

}  // namespace fpkcheck::sweep
