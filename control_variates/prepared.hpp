#pragma once

#include <Eigen/Core>

#include "control_variates/functionals.hpp"
#include "mcs/deposit/grid.hpp"
#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::control_variates {

/// Numbers of cells of the control functions in y and y'. 40 x 88 suffice for moments.
struct Cells {
  int y = 80, v = 176;
};

/// Layout of the deposits, determined by the problem alone: the default splines of the control
/// functions (backward/control/usual_control.hpp), a lattice with a spacing of an eighth of a
/// deviation of the impulses, and smooth bins. The bins have spacings of 0.15 and 0.3 deviations
/// and four times this width, within 7 deviations.
struct Places {
  numerics::KnotSplines y, v;
  mcs::DepositGrid grid;
  Functionals functionals;
};
Places places(const problem::Problem& problem, const Cells& cells);

/// The control functions of all functionals, and precomputed data for their use.
struct Prepared {
  problem::Problem problem;
  Places places;
  /// Column f: coefficients of A_i(y) B_j(v) in the control function h of functional f, row i *
  /// v.size() + j.
  Eigen::MatrixXd control;
  /// (K B_j)(v_q), shape (lattice points, functions of v); the deposits include the factor lambda.
  Eigen::MatrixXd after_impulse;
  std::vector<double> backward_means;  ///< U of each functional, from the backward equation alone
};

/// @param sampling_interval of the simulation; it sets the weight of the impact condition in the
///        fit
/// @throws backward::FitBrokeDown
Prepared prepare(const problem::Problem& problem, const Places& places, double sampling_interval);

}  // namespace fpkcheck::control_variates
