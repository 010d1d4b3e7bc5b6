#pragma once

#include <Eigen/Core>

#include "control_variates/functionals.hpp"
#include "mcs/deposit/grid.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::control_variates {

/// Numbers of cells of the control functions in y and y'. 40 x 88 suffice for moments.
struct ControlCells {
  int y = 80, v = 176;
};

/// Layout of the deposits, determined by the problem alone: the default splines of the control
/// functions (backward/control/paper_class_fit.hpp), a lattice with a spacing of an eighth of a
/// deviation of the impulses, and smooth bins. The bins have spacings of 0.15 and 0.3 deviations
/// and four times this width, within 7 deviations.
struct DepositLayout {
  numerics::QuinticBSplines y, v;
  mcs::DepositGrid grid;
  Functionals functionals;
};
DepositLayout deposit_layout(const problem::Problem& problem, const ControlCells& cells);

/// The control functions of all functionals, and precomputed data for their use.
struct ControlSetup {
  problem::Problem problem;
  DepositLayout deposit_layout;
  /// Column f: coefficients of A_i(y) B_j(v) in the control function h of functional f, row i *
  /// v.size() + j.
  Eigen::MatrixXd control;
  /// (K B_j)(v_q), shape (lattice points, functions of v); the deposits include the factor lambda.
  Eigen::MatrixXd after_impulse;
  std::vector<double> backward_means;  ///< U of each functional, from the backward equation alone
};

/// @param sampling_interval of the simulation; it sets the weight of the impact condition in the
///        fit
/// @throws backward::FitFailure
ControlSetup make_control_setup(const problem::Problem& problem,
                                const DepositLayout& deposit_layout, double sampling_interval);

}  // namespace fpkcheck::control_variates
