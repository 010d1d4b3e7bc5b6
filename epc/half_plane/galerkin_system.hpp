#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/half_plane_basis.hpp"

namespace fpkcheck::epc::half_plane {

/// Part of L*phi_k, for the basis functions phi_k, that is multiplied by a time-dependent factor of
/// the excitation and added to GalerkinQuadratureTables::generator_terms.
struct TimeDependentGeneratorTerm {
  std::function<double(double t)> factor;
  Eigen::MatrixXd values;
};

/// Values of the basis functions phi_k, and of the generator L* of the impact process applied to
/// phi_k, at quadrature points on the half-plane y >= 0.
struct GalerkinQuadratureTables {
  Eigen::VectorXd weight;
  BasisValuesAtPoints basis_functions;
  /// Mean rate of change L*phi_k of the basis function phi_k between impacts, shape (points,
  /// functions)
  Eigen::MatrixXd generator_terms;
  /// Terms of the generator L*phi_k whose factors change in time; empty for a constant excitation
  std::vector<TimeDependentGeneratorTerm> time_dependent_terms = {};
  Eigen::VectorXd confinement_terms;

  /// Quadrature weights of the points at the wall y = 0 with the velocities v < 0 before an impact
  Eigen::VectorXd wall_weight;
  Eigen::MatrixXd wall_basis_functions;
  /// Change of basis function phi_k in an impact times impact speed: |v| [phi(0,-r v) - phi(0,v)]
  Eigen::MatrixXd impact_terms;
  Eigen::VectorXd wall_confinement_terms;
};

/// Galerkin equations of a density p = C exp(sum_k a_k phi_k + confinement term) on y >= 0,
///
///     R_phi = int p L*phi dy dv + int_{v<0} |v| p(0,v) [phi(0,-r v) - phi(0,v)] dv = 0
///
/// for every basis function phi. The residual R_phi is the rate of change of the mean E[phi] under
/// the exact process, if the state has the density p.
class GalerkinSystem {
 public:
  explicit GalerkinSystem(GalerkinQuadratureTables tables) : tables_(std::move(tables)) {}

  Eigen::Index size() const { return tables_.basis_functions.size(); }

  struct DensityAtPoints {
    Eigen::VectorXd mass;          ///< probability at the interior points; the sum is 1
    Eigen::VectorXd wall_mass;     ///< probability p(0, v) dv at the points on the wall
    double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
    double peak = 0;
    bool finite = false;  ///< whether the normalisation and wall_mass are finite
  };
  /// Returns the normalised density with the given coefficients of Q_n at all quadrature points.
  DensityAtPoints evaluate_density(const Eigen::VectorXd& coefficients) const;

  /// Returns the means E[phi] of the basis functions phi under a density.
  /// @param mass probability at each quadrature point
  Eigen::VectorXd basis_function_means(const Eigen::VectorXd& mass) const;
  /// Returns the residual R_phi of the Galerkin equation of every basis function phi.
  /// @param t time, for an excitation that changes in time; absent for the constant excitation
  Eigen::VectorXd residual(const DensityAtPoints& density, std::optional<double> t = {}) const;
  /// Returns the Jacobian with the derivative dR_phi/da_k in row phi and column k, from the
  /// covariances of L*phi and the basis functions.
  /// @param t time, for an excitation that changes in time
  Eigen::MatrixXd jacobian(const DensityAtPoints& density, std::optional<double> t = {}) const;
  /// Returns the covariance matrix of the basis functions under the closure density. In the norm of
  /// the covariance matrix, the length of a step in the coefficients of Q_n is the standard
  /// deviation of the change of Q_n.
  Eigen::MatrixXd covariance(const DensityAtPoints& density) const;

  /// Returns the coefficients of the least-squares fit of the exponent Q_n to given values.
  /// @param exponent values of the exponent at the quadrature points
  /// @param mass weights of the quadrature points in the fit
  Eigen::VectorXd fit_exponent_coefficients(const Eigen::VectorXd& exponent,
                                            const Eigen::VectorXd& mass) const;

 private:
  GalerkinQuadratureTables tables_;
};

/// Galerkin equations of a closure, together with their basis and their quadrature points.
class ClosureEquations : public GalerkinSystem {
 public:
  ClosureEquations(GalerkinQuadratureTables tables, OrthonormalBasis basis, QuadraturePoints points)
      : GalerkinSystem(std::move(tables)), basis_(std::move(basis)), points_(std::move(points)) {}

  const OrthonormalBasis& basis() const { return basis_; }
  const QuadraturePoints& points() const { return points_; }

 private:
  OrthonormalBasis basis_;
  QuadraturePoints points_;
};

/// Returns the closure density with given coefficients in the basis, without
/// ClosureDensity::end_of_exponent_decay.
/// @param level confinement level of the equations
ClosureDensity make_closure_density(const ClosureEquations& equations,
                                    const Eigen::VectorXd& coefficients, double level,
                                    DensityTailTreatment tail);

}  // namespace fpkcheck::epc::half_plane
