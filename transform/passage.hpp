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

/// Barrier of a first passage at the time tau: a displacement, tau = inf {t : y(t) >= level}, or an
/// energy, tau = inf {t : v^2/2 + U(y) >= level}, with the potential U of the spring, U(0) = 0.
struct PassageBarrier {
  enum class Quantity { displacement, energy };
  Quantity quantity = Quantity::displacement;
  double level = 0;

  bool is_energy() const { return quantity == Quantity::energy; }
};

/// Initial state of a passage.
struct PassageStartState {
  double y = 0, ydot = 0;
};

/// Returns the initial state of first passages from a point, in wall coordinates: the state
/// `given`, or rest below the barrier (problem::rest_displacement()). The initial state is empty if
/// `given` is empty and the mass cannot rest below the barrier.
/// @param transformed problem in wall coordinates
/// @param barrier barrier in wall coordinates
/// @param given initial state in physical coordinates; may be empty
std::optional<PassageStartState> passage_start_state(const problem::Problem& transformed,
                                                     double barrier,
                                                     const std::optional<PassageStartState>& given);

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

/// First passage above a PassageBarrier. Passage times `from_point` start in a PassageStartState,
/// or at rest on the wall or at the equilibrium. Passage times `from_stationary` start from the
/// stationary distribution below the barrier. Passage times and rates that the method does not
/// compute are absent.
struct FirstPassageResult {
  std::string id;  ///< id of the solution, such as "fd-kf", "mcs" or "rice"
  Status status = Status::failed;
  std::string reason = {};  ///< reason of the status, one sentence; empty only for status ok
  double seconds = 0;
  /// Hazard: rate g of first passages at long times, P(tau > t) ~ C exp(-g t) with a constant C.
  std::optional<ValueWithError> hazard = {};
  std::optional<ValueWithError> mean_from_point = {}, mean_from_stationary = {};
  /// Rate of upward crossings of a displacement barrier in the stationary process (Rice).
  std::optional<ValueWithError> rice_rate = {};
  /// Stationary probability of the states below the barrier
  std::optional<ValueWithError> probability_below = {};
  std::vector<double> times = {};
  /// Survival probabilities P(tau > t) of the passage time tau at the times t; empty if the method
  /// computes no survival probabilities.
  std::vector<ValueWithError> survival_from_point = {}, survival_from_stationary = {};
  std::optional<MeanPassageTimeMap> mean_passage_times_by_start =
      {};                            ///< mean times from all starts below the barrier
  bool has_standard_errors = false;  ///< whether the errors are standard errors of a simulation
  /// Whether every value is guaranteed to differ from the exact value by at most its error
  bool has_guaranteed_errors = false;
  std::string details = {};  ///< grid or simulated time, for tables
};

}  // namespace fpkcheck::transform
