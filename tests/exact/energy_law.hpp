#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::exact {

/// Density under white noise with elastic walls or none and a damping force that depends on the
/// energy only (Caughey): with H = v^2/2 + V(y), V = U - lambda E[Y] y, and the damping f = v h(H),
///
///     p(y, v) ~ exp(-(1/D_eff) int_0^H h),    D_eff = D + lambda E[Y^2] / 2,
///
/// between the walls at any positions: potentials with several wells, a gap or preload at the wall,
/// two walls, a bouncing ball (f = c v), and the ring-shaped density of g = k y with
/// f = v (c + c_vv (k y^2 + v^2)). Impulses are replaced by white noise of their intensity and mean
/// (equation `white`).
class EnergyLaw {
 public:
  /// @throws InputError when a wall has losses, or the damping is not a function of the energy
  explicit EnergyLaw(const problem::Problem& problem);

  double operator()(double y, double v) const;
  /// Marginal densities p(y) and p(v).
  double displacement_marginal(double y) const;
  double velocity_marginal(double v) const;
  /// E[y^p v^q].
  double moment(int p, int q) const;

 private:
  struct Point {
    double at, weight;
  };
  double unnormalised(double y, double v) const;

  numerics::Polynomial potential_;
  double linear_, quadratic_;  // the exponent is linear H + quadratic H^2
  double min_exponent_ = 0;    // minimum of the exponent
  double y_low_ = 0, y_high_ = 0;
  std::vector<Point> y_, v_;  // quadrature rules over the support
  double norm_ = 1;
};

}  // namespace fpkcheck::exact
