#pragma once

#include <Eigen/Core>

#include "problem/equation_and_impact_condition.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::linearisation {

/// Gaussian density of the displacement y and the velocity v, which are independent:
///
///     p(y, v) = phi((y - m) / s_y) phi(v / s_v) / (s_y s_v)      without a wall,
///     p(y, v) = 2 phi(y / s_y) phi(v / s_v) / (s_y s_v), y > 0   with a wall at y = 0,
///
/// where phi is the standard normal density. With a wall this is the density of y = |z| and
/// v = z' sgn z for a Gaussian z with mean 0 (Zhuravlev's transformation).
struct GaussianDensity {
  double mean_displacement;  ///< m; 0 with a wall
  double displacement_deviation;
  double velocity_deviation;
};

/// Half-width of the domain of a GaussianDensity in standard deviations. The density at the edge of
/// the domain is exp(-32) of its peak.
inline constexpr double kDomainDeviations = 8;

/// The stationary moment equations of the oscillator for E[v], E[y v] and E[v^2] under a
/// GaussianDensity, as functions of the logarithms of its deviations and of its mean:
///
///     E[a] = 0,    E[v^2] + E[y a] = 0,    2 E[v a] + 2 E[D_total] - 2 W = 0.
///
/// Here a = -(f + g) + lambda E[Y] b is the drift of v, 2 D_total = 2 D G + lambda E[Y^2] b^2 is
/// the diffusion of v, and W is the energy that impacts dissipate per unit time. The equation of
/// E[v] is absent with a wall. The residuals are divided by the scales of force, virial and power
/// of the initial density.
class MomentEquations {
 public:
  /// @param problem problem in wall coordinates, without a right wall
  /// @param initial_density approximation of the solution, which fixes the scales
  MomentEquations(const problem::Problem& problem, problem::ImpactCondition impact,
                  const GaussianDensity& initial_density);

  Eigen::VectorXd unknowns_of(const GaussianDensity& density) const;
  GaussianDensity density_of(const Eigen::VectorXd& unknowns) const;

  Eigen::VectorXd residuals_at(const Eigen::VectorXd& unknowns) const;

 private:
  const problem::Problem& problem_;
  problem::ImpactCondition impact_;
  bool has_wall_;
  GaussianDensity initial_density_;
};

}  // namespace fpkcheck::linearisation
