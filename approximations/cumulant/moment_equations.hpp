#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "problem/equation_and_impact_condition.hpp"
#include "problem/impulse_law.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::cumulant {

/// Cumulants of the displacement y and the velocity v up to an order n. The mean and the
/// cumulants kappa_{p,1}, p < n, of v are 0, since E[y^p v] = 0 in the stationary state.
///
/// With a wall at y = 0 the cumulants are those of (z, z') with y = |z|, y' = z' sgn z
/// (Zhuravlev's transformation), whose density is symmetric: cumulants of odd orders are 0.
struct Cumulants {
  double mean_displacement;  ///< E[y]; 0 with a wall
  double displacement_deviation, velocity_deviation;
  /// Standardised cumulants kappa_{p,q} / (s_y^p s_v^q) as entries (p, q) of a matrix with n + 1
  /// rows and columns; the entries (2, 0) and (0, 2) are 1.
  Eigen::MatrixXd standardised;

  int order() const { return static_cast<int>(standardised.rows()) - 1; }
};

/// The coefficients of the equation of motion, in units of the displacement s_y, the velocity s_v
/// and the time s_y / s_v, where s_y and s_v are the deviations of MotionScales.
struct PolynomialCoefficients {
  double displacement_unit, velocity_unit;
  Eigen::MatrixXd force = {};      ///< coefficients of y^i v^j in the total force
  Eigen::MatrixXd diffusion = {};  ///< coefficients of y^i v^j in the diffusion D G of white noise
  /// Coefficients of y^i in lambda E[Y^j] b(y)^j, one column, at index j; b is the impulse factor.
  std::array<Eigen::MatrixXd, problem::kMomentCount> jump_moments = {};
};

/// Returns the polynomial coefficients; nullopt if the force, the diffusion of the noise or the
/// impulse factor is no polynomial of degree up to 6 in y and v where the density is large.
/// @param problem problem in wall coordinates
std::optional<PolynomialCoefficients> polynomial_coefficients(const problem::Problem& problem,
                                                              const problem::MotionScales& scales);

/// The stationary moment equations for E[y^p v^q], q >= 1, p + q <= n, of the oscillator
/// v' = -F(y, v) + sqrt(2 D G) W(t) + impulses b(y) Y of the rate lambda,
///
///     p E[y^(p-1) v^(q+1)] - q E[y^p v^(q-1) F] + q (q-1) E[y^p v^(q-2) D G]
///         + sum_{j=1..q} C(q, j) lambda E[Y^j] E[y^p v^(q-j) b^j] + I_pq = 0,
///
/// with binomial coefficients C. Moments above the order n follow from cumulants above the order n
/// that are 0. Impulses enter exactly. With a wall p + q is even. Moments of odd order and the
/// impact term I_pq then follow from the Gram-Charlier density p_z of (z, z'),
///
///     I_0q = -2 (1 - r^q) / (1 + r^q) int |u|^(q+1) p_z(0, u) du,    I_pq = 0 for p > 0.
///
/// An impact multiplies the flux int |u|^(q+1) p_z(0, u) du of |v|^q at the wall by r^q. The smooth
/// density p_z cannot represent the discontinuity of the exact density at z = 0; p_z(0, u) is taken
/// as the mean of the densities before and after the impact. The impact condition `delta` has the
/// factor -q (1 - r), the impulsive damping term of paper (13).
class MomentEquations {
 public:
  /// @param problem problem in wall coordinates, without a right wall
  MomentEquations(const problem::Problem& problem, problem::ImpactCondition impact,
                  const PolynomialCoefficients& coefficients, int order);

  Eigen::VectorXd unknowns_of(const Cumulants& cumulants) const;
  Cumulants cumulants_of(const Eigen::VectorXd& unknowns) const;

  Eigen::VectorXd residuals_at(const Eigen::VectorXd& unknowns) const;

 private:
  using Exponents = std::pair<int, int>;  // p and q of y^p v^q
  Eigen::MatrixXd moments_of(const Cumulants& cumulants) const;
  double impact_term(const Cumulants& cumulants, int q) const;
  double moment_equation_residual(const Eigen::MatrixXd& moments, int p, int q) const;

  const problem::Problem& problem_;
  problem::ImpactCondition impact_;
  const PolynomialCoefficients& coefficients_;
  int order_;
  bool has_wall_;
  int max_moment_order_ = 0;               // largest order of a moment in the equations
  std::vector<Exponents> equations_;       // exponents of the moment equations
  std::vector<Exponents> free_cumulants_;  // unknown cumulants of the orders 3 .. n
};

/// Returns the Gram-Charlier polynomial of the standardised variables with given cumulants.
Eigen::MatrixXd gram_charlier_polynomial(const Cumulants& cumulants);

}  // namespace fpkcheck::cumulant
