#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::sweep {

/// Dimensionless groups of a problem. In the base class of problems (problem/problem_features.hpp),
/// the dimensionless groups, the restitution coefficient and the amplitude law determine the
/// density up to units.
struct DimensionlessGroups {
  double impulses_per_decay_time;  ///< ratio lambda / kappa (problem::impulses_per_decay_time)
  double damping_ratio;            ///< ratio c / (2 sqrt(k_eq)), with the equivalent stiffness k_eq
  /// Cubic fraction of the stiffness, 1 - k / k_eq, with the linear stiffness k and the equivalent
  /// stiffness k_eq. The cubic fraction of the stiffness is 0 for a linear spring, 1 for a purely
  /// cubic spring, and NaN for problems outside the base class.
  double cubic_share;
};

DimensionlessGroups dimensionless_groups(const problem::Problem& problem);

/// Dimensionless parameters that determine the density up to the units of length and time.
struct ValidityMapCoordinates {
  DimensionlessGroups groups;
  double restitution;
  std::string law;
  double relative_mean;  ///< relative mean E[Y] / sqrt(E[Y^2]) of the impulses
};

ValidityMapCoordinates validity_map_coordinates(const problem::Problem& problem);

/// Returns the distance between two problems in the validity map,
///
///     sqrt( (ln N1/N2)^2 + (ln zeta1/zeta2)^2 + ((r1 - r2)/0.1)^2 + ((s1 - s2)/0.2)^2 ),
///
/// where N is the number of impulses per decay time, zeta the damping ratio, r the restitution
/// coefficient, and s the cubic fraction of the stiffness. A distance of 1 corresponds to a factor
/// e in the impulses per decay time N or the damping ratio zeta, to 0.1 in the restitution
/// coefficient r, or to 0.2 in the cubic fraction s. The distance in the validity map is infinite
/// if the laws or the relative means of the impulse amplitudes differ. The file docs/validity.md
/// states how impulse rate, damping ratio, restitution coefficient and cubic stiffness affect the
/// errors of the methods.
double validity_map_distance(const ValidityMapCoordinates& one,
                             const ValidityMapCoordinates& other);

struct ValidityMapResult {
  transform::Status status;
  /// Larger of the L1 distances of p(y) and p(y') from the reference solution; for the reference
  /// itself, its error estimate. The L1 distance is empty if the method gives no density.
  std::optional<double> l1;
  /// Whether a method underestimates its error: the status is `ok`, but the L1 distance exceeds
  /// twice the stated error plus the error estimate of the reference.
  bool underestimated;
  double seconds;

  bool has_status_ok() const { return status == transform::Status::ok; }
};

struct ValidityMapPoint {
  ValidityMapCoordinates coordinates;
  /// Result of each method at a map point, in the order of ValidityMap::methods; empty for a method
  /// without a result.
  std::vector<std::optional<ValidityMapResult>> method_results;
};

/// Results of many methods for problems over a range of parameters, the validity map of
/// docs/validity.md.
struct ValidityMap {
  /// Ids of the methods in the validity map; the last method is the reference of every point.
  std::vector<std::string> methods;
  std::vector<ValidityMapPoint> points;
};

/// Reads a validity map from comma-separated values. The first line of a validity map has the names
/// of the columns impulses_per_decay_time, damping_ratio, cubic_share, restitution, law,
/// mean_share, ID, .. Each following line is a point of the validity map. The table cell under the
/// id of a method has the L1 distance, the letter of the status, and milliseconds, e.g.
/// ".0042o310", or "i5.1" without a density. The table cell of a method is empty if the method was
/// not used at the map point. The letters of the statuses are o ok, x ok but error underestimated,
/// i inaccurate, a inadmissible, n not_converged, p ill_posed, f failed, u not_offered.
/// @throws InputError with a message of one line
ValidityMap read_validity_map(std::string_view text);

/// Returns the validity map that is compiled into the program: validity.csv, made by
/// scripts/validity.
const ValidityMap& shipped_validity_map();

}  // namespace fpkcheck::sweep
