#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/functionals/grid_sequence.hpp"
#include "fd_fpk/functionals/reduced_resolvent.hpp"
#include "fd_fpk/options.hpp"
#include "problem/motion_scales.hpp"
#include "transform/passage.hpp"

/// Values of a first passage on one grid and on a sequence of grids, for barriers of the
/// displacement and of the energy.
namespace fpkcheck::fd_fpk {

/// Indices of the values in the vector of a grid. After the values with indices below kValueCount
/// the vector contains the survival probabilities from the initial state and from the stationary
/// law.
enum PassageValue {
  kHazard,
  kFromPoint,
  kFromStationary,
  kRiceRate,
  kProbabilityBelow,
  kUpperExitFromPoint,
  kUpperExitFromStationary,
  kValueCount
};

/// Initial conditions of a passage, as functionals of the survival probability on a grid.
struct PassageInitialConditions {
  /// Functional of the initial state; empty without an initial state. From rest under impulses, the
  /// functional is the mean over the states after the first impulse.
  std::optional<Eigen::VectorXd> from_point = {};
  Eigen::VectorXd from_stationary;
  /// Rate of the impulses that end the rest of an initial state at rest; 0 if noise ends the rest,
  /// or if the initial state moves
  double waiting_rate = 0;
};

/// Computes the hazard, the mean passage times and the survival probabilities at the given times in
/// the Krylov space of a model of the survival probability. The Krylov space grows until the values
/// of two successive spaces agree. The values with the indices from kRiceRate are 0.
/// @param accuracy FiniteVolumeOptions::accuracy
/// @return the values; empty with a reason in `failure`
Eigen::VectorXd compute_passage_values(ReducedResolvent& model,
                                       const PassageInitialConditions& starts,
                                       const std::vector<double>& times, double accuracy,
                                       const base::Deadline& deadline, std::string& failure);

/// Returns the shift of the Krylov space. Smaller shifts slow down the convergence of the survival
/// probability at short times; larger shifts slow down the convergence of the hazard.
inline double survival_resolvent_shift(const problem::MotionScales& scales) {
  constexpr double kShift = 4;
  return kShift * scales.velocity_deviation / scales.displacement_deviation;
}

/// Values on one grid, and the mean times in its cells.
struct PassageResultOnGrid {
  FunctionalValuesOnGrid values_on_grid = {};
  std::optional<transform::MeanPassageTimeMap> mean_passage_times_by_start = {};
};

/// Largest order of convergence for the error estimates of passages. The survival probability of
/// one barrier without noise jumps across the orbit that grazes the barrier, which limits the order
/// of finite volumes.
inline constexpr int kPassageOrder = 2;

/// Function that computes the values on the grid with automatic cells divided by `refinement`, with
/// the survival probabilities at the given times.
using SolvePassageOnGrid =
    std::function<PassageResultOnGrid(double refinement, const std::vector<double>& times)>;

/// Computes the values on a sequence of grids (FunctionalValuesFromGridSequence) and stores the
/// values, the errors and the status in `passage`.
/// @param order order of convergence for the error estimates
/// @param times times of the survival probabilities; automatic times if empty
/// @param has_start whether the passage has an initial state
/// @param element_name name of the elements of a grid in FirstPassageResult::details: cells or
/// nodes
void solve_passage_on_grids(const SolvePassageOnGrid& solve_on_grid,
                            const FiniteVolumeOptions& options, int order,
                            std::vector<double> times, bool has_start, const char* element_name,
                            const base::Deadline& deadline, transform::FirstPassageResult& passage);

}  // namespace fpkcheck::fd_fpk
