#pragma once

#include <utility>

#include <Eigen/Core>

namespace fpkcheck::epc::half_plane {

/// Functions phi_k, the members, at the points of a quadrature rule on the half-plane y >= 0, and
/// what the impact process makes of them.
struct GalerkinTables {
  Eigen::VectorXd weight;     ///< of the points inside
  Eigen::MatrixXd members;    ///< phi, shape (points, members)
  Eigen::MatrixXd generated;  ///< L*phi, the rate at which the process changes phi between impacts
  Eigen::VectorXd confined;   ///< the confinement's term

  Eigen::VectorXd wall_weight;   ///< of the points on the wall's incoming side, y = 0, v < 0
  Eigen::MatrixXd wall_members;  ///< phi
  Eigen::MatrixXd rebounds;      ///< |v| [phi(0,-r v) - phi(0,v)]
  Eigen::VectorXd wall_confined;
};

/// The Galerkin equations of a density p = C exp(sum_k a_k phi_k + confinement) on y >= 0,
///
///     R_phi = int p L*phi dy dv + int_{v<0} |v| p(0,v) [phi(0,-r v) - phi(0,v)] dv = 0
///
/// for every member phi. R_phi is d E[phi]/dt: how fast the mean of phi changes under the true
/// process when the density is p.
class Galerkin {
 public:
  explicit Galerkin(GalerkinTables tables) : tables_(std::move(tables)) {}

  /// Number of members.
  Eigen::Index size() const { return tables_.members.cols(); }

  /// The density at given coefficients, and what Newton's method needs of it.
  struct Density {
    Eigen::VectorXd mass;          ///< at the points inside, summing to 1
    Eigen::VectorXd wall_mass;     ///< p(0, v) dv at the points on the wall
    double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
    double peak = 0;               ///< largest exponent at the points
    bool finite = false;
  };
  Density density(const Eigen::VectorXd& a) const;

  /// R_phi for each member.
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

  GalerkinTables tables_;
};

}  // namespace fpkcheck::epc::half_plane
