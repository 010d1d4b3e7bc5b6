#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "backward/control_variates/control_variate_functions.hpp"
#include "mcs/deposit/sample_deposit.hpp"
#include "mcs/summary.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::control_variates {

/// Exponents of a moment E[y^p y'^q].
struct MomentExponents {
  int p, q;
};
inline constexpr std::array<MomentExponents, 6> kMoments{
    {{1, 0}, {2, 0}, {4, 0}, {0, 1}, {0, 2}, {0, 4}}};

/// The estimated expectations E[f], in the order: moments, smooth bins of y, smooth bins of y'.
struct EstimatedFunctionals {
  transform::SmoothBins y_bins, v_bins;

  int functional_count() const {
    return static_cast<int>(kMoments.size()) + y_bins.count + v_bins.count;
  }
  /// Returns the function f of each estimated expectation E[f].
  std::vector<backward::SeparableFunction> integrands_of_functionals() const;
  /// Returns the sample mean of each function f in one stream, without control variates.
  std::vector<double> functional_means_in_stream(
      const mcs::DepositedSumsOfTrajectory& stream) const;
};

/// Numbers of spline cells in y and in y' of the control functions h, whose images L h under the
/// generator L are the control variates. If the simulation estimates only moments, 40 x 88 spline
/// cells suffice for the control functions.
struct ControlVariateSplineCellCounts {
  int y = 64, v = 100;
};

/// Layout of the sums over samples that the simulation deposits for the control variates. The
/// layout of the sums depends on the problem and on the spline cells of the control variates.
///  - Splines: the default splines of the control functions
///    (backward/control_variates/control_variate_fit.hpp).
///  - Velocity lattice: spacing of an eighth of the standard deviation of the impulses.
///  - Smooth bins: spacing of 0.15 standard deviations of y and 0.3 standard deviations of y'. Each
///    smooth bin is four spacings wide, and the smooth bins extend to 7 standard deviations.
struct DepositionSplineLayout {
  numerics::QuinticBSplines y, v;
  mcs::SampleDepositionGrid grid;
  EstimatedFunctionals functionals;
};
DepositionSplineLayout make_deposition_spline_layout(const problem::Problem& problem,
                                                     const ControlVariateSplineCellCounts& cells);

/// Control functions and tables for estimates from the deposited sums of a simulation.
struct ControlVariateSetup {
  problem::Problem problem;
  DepositionSplineLayout deposit_layout;
  /// Spline coefficients of the control functions h of the control variates L h: column f belongs
  /// to functional f, and row i * v.size() + j to the spline product A_i(y) B_j(v).
  Eigen::MatrixXd control;
  /// Means (K B_j)(v_q) = E[B_j(v_q + Y)] of the splines B_j after an impulse Y at the lattice
  /// points v_q, of shape (lattice points, splines of v). The deposited sums on the velocity
  /// lattice contain the arrival rate lambda of the impulses as a factor.
  Eigen::MatrixXd after_impulse;
  /// Estimates of the means E[f] from the fitted backward equation, computed without simulation.
  std::vector<double> backward_means;
};

/// Fits the splines of the control functions.
/// @param sampling_interval time between samples of the simulation; its reciprocal is the weight of
///   the impact condition in the fit
/// @throws backward::LeastSquaresFitFailure
ControlVariateSetup make_control_variate_setup(const problem::Problem& problem,
                                               const DepositionSplineLayout& deposit_layout,
                                               double sampling_interval);

}  // namespace fpkcheck::control_variates
