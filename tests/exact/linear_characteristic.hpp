#pragma once

#include <array>
#include <vector>

#include "exact/decaying_wave.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::exact {

/// The stationary characteristic function of (z, z') for the linear oscillator (mu = 0,
/// c^2 < 4k) with r = 1 under impulses with a symmetric law,
///
///     log phi(u1, u2) = lambda int_0^inf ( M(u1 h(t) + u2 h'(t)) - 1 ) dt,
///     h(t) = exp(-ct/2) sin(wt)/w,   w = sqrt(k - c^2/4),
///
/// with the characteristic function M of Y: filtered Poisson impulses (Campbell's theorem). phi is
/// real, positive and even, and decays like |u|^(-2 lambda / c).
class LinearCharacteristicFunction {
 public:
  /// @throws InputError with the parameter for which the formula does not hold
  explicit LinearCharacteristicFunction(const problem::Problem& problem);

  /// phi(u1, u2) = E[exp(i (u1 z + u2 z'))]. The relative error is below 1e-12 for frequent
  /// impulses: the rounding error of the logarithm is about 1e-16 lambda/c.
  double operator()(double u1, double u2) const;
  double logarithm(double u1, double u2) const;

  /// The radius R in u1 h(t) + u2 h'(t) = R exp(-ct/2) sin(wt + phase):
  /// R^2 = u2^2 + ((u1 - c u2 / 2) / w)^2.
  double radius(double u1, double u2) const;
  /// The largest value of phi over all waves with radius(u1, u2) >= `radius`, which is the largest
  /// value on the ellipse of this radius. Proof: phi decreases along each spiral (u1, u2)(t) on
  /// which u1 h + u2 h' runs backwards in time, and all spirals cross the ellipse.
  double max_beyond(double radius) const;

 private:
  static constexpr int kPanelOrder = 20;
  using Panel = std::array<double, kPanelOrder + 1>;

  double integrate_wave(const DecayingWave& wave, double end) const;
  double logarithm_from_zero(double amplitude) const;
  double integrate_from_zero(double amplitude, double table_end) const;
  double small_amplitude_series(double amplitude) const;
  double interpolate_table(double amplitude) const;
  void tabulate();

  problem::System system_;
  problem::ImpulseTrain impulses_;
  double scale_;  ///< standard deviation of Y
  /// The logarithm for waves with phase 0, at Chebyshev points of panels of the amplitude. The
  /// panels have the width 1/scale_ and begin at 0.
  std::vector<Panel> panels_;
};

}  // namespace fpkcheck::exact
