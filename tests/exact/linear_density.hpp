#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "exact/linear_characteristic.hpp"

namespace fpkcheck::exact {

/// The stationary density of the linear oscillator (mu = 0, c^2 < 4k) with r = 1 under impulses
/// with a symmetric law: p(y, v) = 2 p_Z(y, v), y >= 0, by Fourier inversion of its characteristic
/// function. The exact solution of the Kolmogorov-Feller equation (`kf`) for any rate of impulses.
///
/// The sum over the waves is the trapezoidal rule. Its only errors are the probability outside its
/// periods and the omitted waves; `cutoff` limits both. Since phi decays like |u|^(-2 lambda / c),
/// rare impulses need many waves. In case 1 of the paper (lambda / c = 10) the default cut-off
/// gives errors of 1e-14 of the peak in 0.1 s. The default is feasible for lambda / c >= 6, a
/// cut-off of 1e-11 for 5, and of 1e-8 for 3; problems that need more waves are refused.
/// joint_truncation() estimates the error.
class LinearDensity {
 public:
  /// @param cutoff waves with phi below the cut-off are omitted, 0 < cutoff < 1
  /// @throws InputError for a parameter for which the formula does not hold
  ///         (LinearCharacteristicFunction), for lambda <= c, where the density is not bounded, and
  ///         for a cut-off that needs too many waves
  explicit LinearDensity(const problem::Problem& problem, double cutoff = 1e-14);

  /// E[exp(i (u1 z + u2 z'))].
  double characteristic_function(double u1, double u2) const { return phi_(u1, u2); }

  /// Averages of p(y), paper (30), over the bins between `edges`.
  /// @param edges increasing, non-negative
  /// @throws InputError for other edges
  std::vector<double> displacement_averages(std::span<const double> edges) const;
  /// Averages of p(y'), paper (34): 2 int_{z>0} p_Z(z, v) dz, over the bins between `edges`. p(y')
  /// is not even (nor is the density of z'): impulses raise the energy instantly, damping
  /// dissipates it continuously, so that the motion towards the wall differs from the motion away
  /// from it.
  /// @throws InputError when the edges do not increase
  std::vector<double> velocity_averages(std::span<const double> edges) const;
  /// Averages of the joint density p(y, v) over the cells between the edges.
  /// @return row-major, shape (number of y cells, number of v cells)
  /// @throws InputError when edges do not increase or y_edges are negative
  std::vector<double> joint_averages(std::span<const double> y_edges,
                                     std::span<const double> v_edges) const;

  /// Estimate of the error in p(y, v) by the omitted waves, from
  /// phi ~ cutoff (R0 / R)^(2 lambda / c) beyond the radius R0 of the cut-off.
  double joint_truncation() const { return joint_truncation_; }
  /// Ranges of |z| and |z'|, outside of which the probability is about `cutoff`; the density is set
  /// to zero there.
  double displacement_range() const { return z_.range; }
  double velocity_range() const { return v_.range; }

 private:
  /// Wavenumbers n pi / range, n = 0 .. count - 1.
  struct Axis {
    double range;
    int count;
  };
  Eigen::MatrixXd averages(const Eigen::MatrixXd& even_y, const Eigen::MatrixXd& odd_y,
                           std::span<const double> v_edges) const;

  LinearCharacteristicFunction phi_;
  Axis z_{}, v_{};
  double joint_truncation_;
  /// p(y, v) = sum_nm even(n, m) cos(u_n y) cos(w_m v) - odd(n, m) sin(u_n y) sin(w_m v).
  Eigen::MatrixXd even_, odd_;
};

}  // namespace fpkcheck::exact
