#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// A number with an absolute error, which is an estimated discretisation error or a standard error.
struct ValueWithError {
  double value = 0;
  double error = 0;
};

/// Barrier of a first passage: a displacement, tau = inf {t : y(t) >= level}, or an energy, tau =
/// inf {t : v^2/2 + U(y) >= level}, with the potential U of the spring, U(0) = 0. Two barriers of
/// the displacement are a passage out of an interval, tau = inf {t : y(t) >= level or y(t) <=
/// lower_level}.
struct PassageBarrier {
  enum class Quantity { displacement, energy };
  Quantity quantity = Quantity::displacement;
  double level = 0;
  std::optional<double> lower_level = {};  ///< second barrier of the displacement, below `level`

  bool is_energy() const { return quantity == Quantity::energy; }
};

/// Initial state of a passage.
struct PassageStartState {
  double y = 0, ydot = 0;
};

/// Returns the initial state of first passages from a point, in wall coordinates: the given state, or rest
/// below the barrier (problem::rest_displacement()). The result is empty if no state is given and
/// the mass does not rest below the barrier, or not above the lower of two barriers.
/// @param transformed problem in wall coordinates
/// @param barrier,lower_barrier barriers in wall coordinates; `lower_barrier` may be empty
/// @param given state in physical coordinates
std::optional<PassageStartState> passage_start_state(
    const problem::Problem& transformed, double barrier,
    const std::optional<PassageStartState>& given, const std::optional<double>& lower_barrier = {});

/// Returns the level of an energy barrier in wall coordinates, with the potential equal to 0 at the
/// origin of the wall coordinates.
/// @param transformed problem in wall coordinates
/// @param energy level of the energy barrier in physical coordinates
double energy_level_in_wall_coordinates(const problem::Problem& transformed, double energy);

/// Returns ten times up to three mean passage times, for survival probabilities.
std::vector<double> automatic_survival_times(double mean_passage_time);

/// Mean first-passage times T(y, y') for initial states below a barrier, as averages over cells.
struct MeanPassageTimeMap {
  std::vector<double> y_edges, v_edges;  ///< increasing
  std::vector<double> averages;          ///< row-major, shape (ny, nv)
};

/// First passage of a PassageBarrier. Passage times `from_point` start in a PassageStartState,
/// or at rest on the wall or at the equilibrium. Passage times `from_stationary` start from the
/// stationary distribution below the barrier. With two barriers, the states "below the barrier" are
/// those between the barriers. A passage time or rate is absent if the method does not compute this
/// quantity.
struct FirstPassageResult {
  std::string id;  ///< id of the solution, such as "fd-kf", "mcs" or "rice"
  Status status = Status::failed;
  std::string reason = {};  ///< reason of the status, one sentence; empty only for status ok
  double seconds = 0;
  /// Hazard: rate g of first passages at long times, P(tau > t) ~ C exp(-g t) with a constant C.
  std::optional<ValueWithError> hazard = {};
  std::optional<ValueWithError> mean_from_point = {}, mean_from_stationary = {};
  /// Rate of upward crossings of a displacement barrier in the stationary process (Rice); with two
  /// barriers, the rate of exits from the interval.
  std::optional<ValueWithError> rice_rate = {};
  /// Stationary probability of the states below the barrier
  std::optional<ValueWithError> probability_below = {};
  /// Probability that the upper of two barriers is passed first
  std::optional<ValueWithError> upper_exit_from_point = {}, upper_exit_from_stationary = {};
  std::vector<double> times = {};
  /// Survival probabilities P(tau > t) of the passage time tau at the times t; empty if the method
  /// computes no survival probabilities.
  std::vector<ValueWithError> survival_from_point = {}, survival_from_stationary = {};
  std::optional<MeanPassageTimeMap> mean_passage_times_by_start =
      {};                            ///< mean times from all starts below the barrier
  bool has_standard_errors = false;  ///< whether the errors are standard errors of a simulation
  /// Whether the standard errors are increased by an estimate of the error that the interval
  /// between noise kicks causes
  bool has_kick_interval_errors = false;
  /// Whether every value is guaranteed to differ from the exact value by at most its error
  bool has_guaranteed_errors = false;
  std::string details = {};  ///< grid or simulated time, for tables
};

}  // namespace fpkcheck::transform
