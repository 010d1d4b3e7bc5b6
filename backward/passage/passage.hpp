#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"
#include "transform/passage.hpp"

namespace fpkcheck::backward {

/// Options of the collocation method for first passages, the method `characteristics`.
struct PassageCollocationOptions {
  double accuracy = 1e-2;   ///< largest estimated relative error for the status `ok`
  double max_seconds = 10;  ///< time limit in seconds (wall clock)
  /// Whether the result omits the times at which the errors of the survival probabilities exceed
  /// the accuracy. The status does not depend on omitted times. True for automatic times.
  bool omits_inaccurate_times = false;
};

/// Computes the first passage of y above a barrier, by collocation of the renewal equation along
/// the motion between impulses (RenewalEquation). The mean time T(y, v) to the passage from the
/// state (y, v) satisfies
///
///     T(y, v) = int_0^te exp(-lambda t) (1 + lambda h(X_t)) dt,   h(y, v) = E T(y, v + Y),
///
/// where X_t is the motion without impulses from X_0 = (y, v), and te is the time at which this
/// motion passes the barrier, or infinity. T is discontinuous across the trajectory that grazes the
/// barrier. The mean h after an impulse is smooth except at rest on the wall.
///
/// The hazard is the least number g for which 1 is an eigenvalue of lambda A, where A is the
/// operator of RenewalEquation with the weight w(t) = exp(-(lambda - g) t). A
/// ReducedOrderPassageModel gives the survival probabilities, and StationaryCrossings give the
/// values of the stationary start. The values of the stationary start are absent if there is a
/// right wall, or if the error of the stationary law is above half of the accuracy at the time
/// limit. The error estimate of a value is four times its difference from the value on the
/// previous, coarser grid, plus, for survival probabilities, the change by the last shifts of the
/// reduced model. The values of the stationary start also have the error of the stationary law.
/// @param times times of the survival probabilities; if empty, those of
/// transform::automatic_survival_times() at which the errors are below the accuracy
/// @param start initial state of FirstPassageResult::mean_from_point; if empty, the initial state
/// is at rest
transform::FirstPassageResult solve_passage(const problem::Problem& problem,
                                            PassageCollocationOptions options, double barrier,
                                            std::vector<double> times = {},
                                            std::optional<transform::PassageStartState> start = {});

}  // namespace fpkcheck::backward
