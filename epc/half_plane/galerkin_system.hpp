#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/half_plane_basis.hpp"

namespace fpkcheck::epc::half_plane {

/// Part of L*phi_k at the quadrature points that an excitation that changes in time multiplies by
/// a factor, in addition to GalerkinQuadratureTables::generator_terms.
struct TimeDependentGeneratorTerm {
  std::function<double(double t)> factor;
  Eigen::MatrixXd values;
};

/// Values of the basis functions phi_k, and of the generator L* of the impact process applied to
/// phi_k, at quadrature points on the half-plane y >= 0.
struct GalerkinQuadratureTables {
  Eigen::VectorXd weight;
  BasisValuesAtPoints basis_functions;
  /// L*phi_k, the mean rate of change of phi_k between impacts, of shape (points, basis functions)
  Eigen::MatrixXd generator_terms;
  /// Terms of L*phi_k whose factors change in time; empty for a constant excitation
  std::vector<TimeDependentGeneratorTerm> time_dependent_terms = {};
  Eigen::VectorXd confinement_terms;

  /// Quadrature weights of the points on the wall before an impact, y = 0 and v < 0
  Eigen::VectorXd wall_weight;
  Eigen::MatrixXd wall_basis_functions;
  /// Change of phi_k in an impact, times the impact speed: |v| [phi(0,-r v) - phi(0,v)]
  Eigen::MatrixXd impact_terms;
  Eigen::VectorXd wall_confinement_terms;
};

/// Galerkin equations of a density p = C exp(sum_k a_k phi_k + confinement) on y >= 0,
///
///     R_phi = int p L*phi dy dv + int_{v<0} |v| p(0,v) [phi(0,-r v) - phi(0,v)] dv = 0
///
/// for every basis function phi. R_phi is the rate of change of E[phi] under the exact process, if
/// the state has the density p.
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
  /// Returns the normalised density with the given coefficients at all quadrature points.
  DensityAtPoints evaluate_density(const Eigen::VectorXd& coefficients) const;

  /// Returns the means E[phi] of the basis functions.
  /// @param mass probability at each quadrature point
  Eigen::VectorXd basis_function_means(const Eigen::VectorXd& mass) const;
  /// Returns the residual R_phi of every basis function phi.
  /// @param t time, for an excitation that changes in time; absent for the constant excitation
  Eigen::VectorXd residual(const DensityAtPoints& density, std::optional<double> t = {}) const;
  /// Returns the Jacobian with dR_phi/da_k in row phi and column k, by covariances of L*phi and the
  /// basis functions.
  /// @param t time, as in residual()
  Eigen::MatrixXd jacobian(const DensityAtPoints& density, std::optional<double> t = {}) const;
  /// Returns the covariance matrix of the basis functions under the density. In the norm of this
  /// matrix, the length of a step in the coefficients a is the standard deviation of the change of
  /// the exponent Q_n.
  Eigen::MatrixXd covariance(const DensityAtPoints& density) const;

  /// Returns the coefficients of the least-squares fit of the exponent Q_n to given values.
  /// @param exponent values at the quadrature points
  /// @param mass weights of the quadrature points in the fit
  Eigen::VectorXd fit_exponent_coefficients(const Eigen::VectorXd& exponent,
                                            const Eigen::VectorXd& mass) const;

 private:
  GalerkinQuadratureTables tables_;
};

/// Galerkin equations together with the basis and the quadrature points.
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

/// Returns the density with the given coefficients in the basis, without
/// ClosureDensity::end_of_exponent_decay.
/// @param level confinement level of the equations
ClosureDensity make_closure_density(const ClosureEquations& equations,
                                    const Eigen::VectorXd& coefficients, double level,
                                    DensityTailTreatment tail);

}  // namespace fpkcheck::epc::half_plane
