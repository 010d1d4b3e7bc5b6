#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "backward/control/control_functions.hpp"
#include "mcs/deposit/deposit.hpp"
#include "mcs/summary.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::control_variates {

/// Exponents of the moment E[y^p y'^q].
struct MomentExponents {
  int p, q;
};
inline constexpr std::array<MomentExponents, 6> kMoments{
    {{1, 0}, {2, 0}, {4, 0}, {0, 1}, {0, 2}, {0, 4}}};

/// The estimated functionals, in this order: moments, smooth bins of y, smooth bins of y'.
struct Functionals {
  transform::SmoothBins y_bins, v_bins;

  int size() const { return static_cast<int>(kMoments.size()) + y_bins.count + v_bins.count; }
  /// The integrands f of all functionals, as functions on the phase plane.
  std::vector<backward::SeparableFunction> integrands() const;
  /// Plain means of the functionals over the samples of one stream.
  std::vector<double> stream_means(const mcs::StreamDeposit& stream) const;
};

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
