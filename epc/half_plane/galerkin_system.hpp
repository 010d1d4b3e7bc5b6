#pragma once

#include <Eigen/Core>
#include <utility>

#include "epc/half_plane/basis.hpp"

namespace fpkcheck::epc::half_plane {

/// Tables of the basis functions phi_k at quadrature points on the half-plane y >= 0. Further
/// tables contain the generator of the impact process, applied to the basis functions.
struct GalerkinTables {
  Eigen::VectorXd weight;             ///< quadrature weights of the interior points
  Eigen::MatrixXd members;            ///< values of phi, shape (points, basis functions)
  Eigen::MatrixXd generator_terms;    ///< L*phi, the mean rate of change of phi between impacts
  Eigen::VectorXd confinement_terms;  ///< confinement term of the exponent at the interior points

  /// quadrature weights of the points on the wall before an impact, y = 0 and v < 0
  Eigen::VectorXd wall_weight;
  Eigen::MatrixXd wall_members;            ///< values of phi at the points on the wall
  Eigen::MatrixXd impact_terms;            ///< |v| [phi(0,-r v) - phi(0,v)]
  Eigen::VectorXd wall_confinement_terms;  ///< confinement term at the points on the wall
};

/// The Galerkin equations of a density p = C exp(sum_k a_k phi_k + confinement) on y >= 0,
///
///     R_phi = int p L*phi dy dv + int_{v<0} |v| p(0,v) [phi(0,-r v) - phi(0,v)] dv = 0
///
/// for every basis function phi. R_phi is d E[phi]/dt, the rate of change of the mean of phi under
/// the exact process, if the state has the density p.
class GalerkinSystem {
 public:
  explicit GalerkinSystem(GalerkinTables tables) : tables_(std::move(tables)) {}

  /// Number of basis functions.
  Eigen::Index size() const { return tables_.members.cols(); }

  /// Density at the quadrature points for given coefficients.
  struct DensityAtPoints {
    Eigen::VectorXd mass;          ///< probability at the interior points; the sum is 1
    Eigen::VectorXd wall_mass;     ///< p(0, v) dv at the points on the wall
    double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
    double peak = 0;               ///< largest exponent at the quadrature points
    bool finite = false;           ///< whether the normalisation and wall_mass are finite
  };
  /// Evaluates the density for the coefficients a.
  DensityAtPoints evaluate_density(const Eigen::VectorXd& a) const;

  /// Residuals R_phi of the equations for all basis functions.
  Eigen::VectorXd residual(const DensityAtPoints& density) const;
  /// Jacobian with dR_phi/da_k in row phi and column k. The entries are covariances of L*phi and
  /// the basis functions.
  Eigen::MatrixXd jacobian(const DensityAtPoints& density) const;
  /// Covariance matrix of the basis functions under the density, which is the Fisher information of
  /// the coefficients a. In the norm of this matrix, the length of a step in a is the standard
  /// deviation of the change of Q_n.
  Eigen::MatrixXd covariance(const DensityAtPoints& density) const;

  /// Coefficients of the least-squares fit of Q_n to an exponent.
  /// @param exponent values of the exponent at the quadrature points
  /// @param mass weights of the quadrature points
  Eigen::VectorXd fit_coefficients(const Eigen::VectorXd& exponent,
                                   const Eigen::VectorXd& mass) const;

 private:
  Eigen::MatrixXd centred_members(const Eigen::MatrixXd& members,
                                  const DensityAtPoints& density) const;

  GalerkinTables tables_;
};

/// Galerkin equations for the functions of a basis, with the basis and the quadrature points.
class ClosureEquations : public GalerkinSystem {
 public:
  ClosureEquations(GalerkinTables tables, Basis basis, QuadraturePoints points)
      : GalerkinSystem(std::move(tables)), basis_(std::move(basis)), points_(std::move(points)) {}

  const Basis& basis() const { return basis_; }
  const QuadraturePoints& points() const { return points_; }

 private:
  Basis basis_;
  QuadraturePoints points_;
};

}  // namespace fpkcheck::epc::half_plane
