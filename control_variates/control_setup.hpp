#pragma once

#include <Eigen/Core>

#include "control_variates/functionals.hpp"
#include "mcs/deposit/deposit_grid.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::control_variates {

/// Numbers of cells of the control functions in y and in y'. For moments 40 x 88 cells suffice.
struct ControlCells {
  int y = 80, v = 176;
};

/// Layout of the deposits, determined by the problem alone. The splines are the default splines of
/// the control functions (backward/control/control_fit.hpp). The spacing of the
/// velocity lattice is an eighth of the standard deviation of the impulses. The smooth bins of y
/// and y' have spacings of 0.15 and 0.3 standard deviations of the variable, a width of four
/// spacings, and extend to 7 standard deviations.
struct DepositLayout {
  numerics::QuinticBSplines y, v;
  mcs::DepositGrid grid;
  Functionals functionals;
};
DepositLayout make_deposit_layout(const problem::Problem& problem, const ControlCells& cells);

/// The control functions of all functionals, with precomputed means after impulses.
struct ControlSetup {
  problem::Problem problem;
  DepositLayout deposit_layout;
  /// Column f: coefficients of A_i(y) B_j(v) in the control function h of functional f, row i *
  /// v.size() + j.
  Eigen::MatrixXd control;
  /// Means after an impulse, (K B_j)(v_q), of shape (lattice points, functions of v). The deposits
  /// include the factor lambda.
  Eigen::MatrixXd after_impulse;
  std::vector<double> backward_means;  ///< U of each functional, from the backward equation alone
};

/// @param sampling_interval time between samples of the simulation; determines the weight of the
/// impact condition in the fit
/// @throws backward::FitFailure
ControlSetup make_control_setup(const problem::Problem& problem,
                                const DepositLayout& deposit_layout, double sampling_interval);

}  // namespace fpkcheck::control_variates
