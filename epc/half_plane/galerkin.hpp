#pragma once

#include <utility>

#include <Eigen/Core>

namespace fpkcheck::epc::half_plane {

/// Tables of the members phi_k of a basis at quadrature points on the half-plane y >= 0, with the
/// generator of the impact process applied to them.
struct GalerkinTables {
  Eigen::VectorXd weight;             ///< quadrature weights of the interior points
  Eigen::MatrixXd members;            ///< phi, shape (points, members)
  Eigen::MatrixXd generator_terms;    ///< L*phi, mean rate of change of phi between impacts
  Eigen::VectorXd confinement_terms;  ///< term of the confinement

  Eigen::VectorXd wall_weight;   ///< weights of the points on the wall before impact, y = 0, v < 0
  Eigen::MatrixXd wall_members;  ///< phi on the wall
  Eigen::MatrixXd impact_terms;  ///< |v| [phi(0,-r v) - phi(0,v)]
  Eigen::VectorXd wall_confinement_terms;
};

/// The Galerkin equations of a density p = C exp(sum_k a_k phi_k + confinement) on y >= 0,
///
///     R_phi = int p L*phi dy dv + int_{v<0} |v| p(0,v) [phi(0,-r v) - phi(0,v)] dv = 0
///
/// for every member phi. R_phi is d E[phi]/dt, the rate of change of the mean of phi under the
/// exact process at the density p.
class Galerkin {
 public:
  explicit Galerkin(GalerkinTables tables) : tables_(std::move(tables)) {}

  /// Number of members.
  Eigen::Index size() const { return tables_.members.cols(); }

  /// Density for given coefficients at the quadrature points.
  struct Density {
    Eigen::VectorXd mass;          ///< at the interior points, with sum 1
    Eigen::VectorXd wall_mass;     ///< p(0, v) dv at the points on the wall
    double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
    double peak = 0;               ///< largest exponent at the points
    bool finite = false;           ///< normalisation and wall_mass are finite
  };
  Density density(const Eigen::VectorXd& a) const;

  /// R_phi for each member.
  Eigen::VectorXd residual(const Density& density) const;
  /// dR_phi/da_k in row phi and column k: covariances of L*phi and the members.
  Eigen::MatrixXd jacobian(const Density& density) const;
  /// Covariance of the members under the density, which is the Fisher information of a. In this
  /// norm the length of a step is the standard deviation of the change of Q_n.
  Eigen::MatrixXd covariance(const Density& density) const;

  /// Coefficients of the least-squares fit to an exponent given at the points, weighted by a mass.
  Eigen::VectorXd fit(const Eigen::VectorXd& exponent, const Eigen::VectorXd& mass) const;

 private:
  Eigen::MatrixXd centred_members(const Eigen::MatrixXd& members, const Density& density) const;

  GalerkinTables tables_;
};

}  // namespace fpkcheck::epc::half_plane
