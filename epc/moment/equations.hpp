#pragma once

#include <vector>

#include <Eigen/Dense>

#include "epc/moment/basis.hpp"
#include "epc/moment/confinement.hpp"
#include "epc/moment/energy_domain.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

/// How many points the rules have: of EnergyDomain::rule, and on the wall.
struct QuadratureSize {
  int y, v, wall;
};

/// The exact moment equations of the impact system for a density p = C exp(Q_n + confinement) on
/// y >= 0, for every test polynomial phi of the basis:
///
///     R_phi = int p L*phi dy dv + int_{v<0} |v| p(0,v) [phi(0,-r v) - phi(0,v)] dv = 0,
///     L*phi = v phi_y - (c v + k y + mu y^3) phi_v + sum_{j=1}^n lambda E[Y^j]/j! d^j phi/dv^j.
///
/// R_phi is d E[phi]/dt: how fast the moment of phi changes under the true process when the density
/// is p. Nothing is cut off, since phi is a polynomial; there is no delta function and no weight.
class Equations {
 public:
  /// @param rate_moment lambda E[Y^j] for j = 0 .. n (0 and those that the excitation lacks unused)
  Equations(const problem::Problem& problem, const std::vector<double>& rate_moment,
            const EnergyDomain& domain, const Confinement& confinement, Basis basis,
            const QuadratureSize& size);

  const Basis& basis() const { return basis_; }
  const Points& points() const { return inside_; }

  /// The density at given coefficients, and what Newton's method needs of it.
  struct Density {
    Eigen::VectorXd mass;          ///< at the points inside, summing to 1
    Eigen::VectorXd wall_mass;     ///< p(0, v) dv at the points on the wall
    double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
    double peak = 0;               ///< largest exponent at the points
    bool finite = false;
  };
  Density density(const Eigen::VectorXd& a) const;

  /// R_phi for each member of the basis.
  Eigen::VectorXd residual(const Density& density) const;
  /// dR_phi/da_k in row phi and column k: covariances of L*phi and the members.
  Eigen::MatrixXd jacobian(const Density& density) const;
  /// Covariances of the members under the density (the Fisher information of a): the metric in
  /// which a step is measured by the standard deviation of the change of Q_n.
  Eigen::MatrixXd covariance(const Density& density) const;

  /// The coefficients nearest to an exponent given at the points, in the mean square under a mass.
  Eigen::VectorXd fit(const Eigen::VectorXd& exponent, const Eigen::VectorXd& mass) const;

 private:
  Eigen::MatrixXd centred(const Eigen::MatrixXd& members, const Density& density) const;

  Basis basis_;
  Points inside_, wall_;
  Eigen::MatrixXd members_, generated_;       // phi and L*phi at the points inside
  Eigen::MatrixXd wall_members_, rebounds_;   // phi and |v| [phi(0,-rv) - phi(0,v)] on the wall
  Eigen::VectorXd confined_, wall_confined_;  // the confinement's term
};

}  // namespace fpkcheck::epc::moment
