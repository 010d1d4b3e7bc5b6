#pragma once

#include <Eigen/Core>

#include "control_variates/functionals.hpp"
#include "mcs/deposit/grid.hpp"
#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::control_variates {

/// Cells of the control functions. 40 x 88 serve for moments.
struct Cells {
  int y = 80, v = 176;
};

/// Where a simulation is to deposit, chosen for a problem alone: the usual splines of its control
/// functions (backward/control/usual_control.hpp), a lattice of an eighth of a deviation of the
/// impulses, and smooth bins 0.15 and 0.3 deviations apart (four times as wide), within 7
/// deviations.
struct Places {
  numerics::KnotSplines y, v;
  mcs::DepositGrid grid;
  Functionals functionals;
};
Places places(const problem::Problem& problem, const Cells& cells);

/// The control functions of all functionals, and what is needed to use them.
struct Prepared {
  problem::Problem problem;
  Places places;
  /// Column f: h of functional f by A_i(y) B_j(v), row i * v.size() + j.
  Eigen::MatrixXd control;
  /// lambda is deposited, this is (K B_j)(v_q), shape (points of the lattice, functions of v).
  Eigen::MatrixXd after_impulse;
  std::vector<double> backward_means;  ///< U of each functional, without any simulation
};

/// @param sampling_interval of the simulation: how much the jumps at the wall count in the fit
/// @throws backward::FitBrokeDown
Prepared prepare(const problem::Problem& problem, const Places& places, double sampling_interval);

}  // namespace fpkcheck::control_variates
