#include "epc/half_plane/galerkin_system.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace fpkcheck::epc::half_plane {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

GalerkinSystem::DensityAtPoints GalerkinSystem::evaluate_density(const VectorXd& a) const {
  const ArrayXd exponent =
      tables_.basis_functions.basis_function_combination(a) + tables_.confinement_terms;
  const ArrayXd wall_exponent = tables_.wall_basis_functions * a + tables_.wall_confinement_terms;
  DensityAtPoints density;
  density.peak = exponent.maxCoeff();
  density.mass = tables_.weight.array() * (exponent - density.peak).exp();
  const double integral = density.mass.sum();
  density.log_normalisation = std::log(integral) + density.peak;
  density.mass /= integral;
  density.wall_mass =
      tables_.wall_weight.array() * (wall_exponent - density.log_normalisation).exp();
  density.finite = std::isfinite(density.log_normalisation) && density.wall_mass.allFinite();
  return density;
}

VectorXd GalerkinSystem::basis_function_means(const VectorXd& mass) const {
  return tables_.basis_functions.basis_means_under_mass(mass);
}

VectorXd GalerkinSystem::residual(const DensityAtPoints& density, std::optional<double> t) const {
  VectorXd rate = tables_.generator_terms.transpose() * density.mass +
                  tables_.impact_terms.transpose() * density.wall_mass;
  if (!t) return rate;
  for (const TimeDependentGeneratorTerm& term : tables_.time_dependent_terms) {
    rate += term.factor(*t) * (term.values.transpose() * density.mass);
  }
  return rate;
}

MatrixXd GalerkinSystem::jacobian(const DensityAtPoints& density, std::optional<double> t) const {
  // The density p has the derivatives d p / d a_k = p (phi_k - E[phi_k]) at the interior points and
  // at the points on the wall. The term of the Jacobian with the mean E[phi_k] is the residual
  // times E[phi_k], which vanishes at a root.
  const BasisValuesAtPoints& phi = tables_.basis_functions;
  MatrixXd result = phi.basis_mean_products(tables_.generator_terms, density.mass);
  const MatrixXd wall_change = density.wall_mass.asDiagonal() * tables_.wall_basis_functions;
  result.noalias() += tables_.impact_terms.transpose() * wall_change;
  if (t) {
    for (const TimeDependentGeneratorTerm& term : tables_.time_dependent_terms) {
      result += term.factor(*t) * phi.basis_mean_products(term.values, density.mass);
    }
  }
  result.noalias() -= residual(density, t) * phi.basis_means_under_mass(density.mass).transpose();
  return result;
}

MatrixXd GalerkinSystem::covariance(const DensityAtPoints& density) const {
  const MatrixXd moments = tables_.basis_functions.basis_second_moments(density.mass);
  const VectorXd mean = moments.col(0).tail(size());
  return moments.bottomRightCorner(size(), size()) - mean * mean.transpose();
}

VectorXd GalerkinSystem::fit_exponent_coefficients(const VectorXd& exponent,
                                                   const VectorXd& mass) const {
  // The first basis function of the fit, 1, represents the constant term of the exponent, since Q_n
  // has no constant term.
  const VectorXd weighted = mass.cwiseProduct(exponent);
  VectorXd right_hand_side(size() + 1);
  right_hand_side << weighted.sum(), basis_function_means(weighted);
  return tables_.basis_functions.basis_second_moments(mass)
      .ldlt()
      .solve(right_hand_side)
      .tail(size());
}

ClosureDensity make_closure_density(const ClosureEquations& equations, const VectorXd& a,
                                    double level, DensityTailTreatment tail) {
  const GalerkinSystem::DensityAtPoints density = equations.evaluate_density(a);
  const QuadraturePoints& points = equations.points();
  ClosureDensity closure{.q = equations.basis().exponent_polynomial(a),
                         .temperature = density.mass.dot(points.v.cwiseAbs2()),
                         .level = level,
                         .support = support_energy(level, tail)};
  // The constant term of the exponent is different in the orthonormal basis and in monomials.
  const double constant =
      closure.q(points.s[0], points.t[0]) -
      equations.basis().basis_values(points.s.head(1), points.t.head(1)).row(0).dot(a);
  closure.log_normalisation = density.log_normalisation + constant;
  closure.peak = density.peak + constant;
  return closure;
}

}  // namespace fpkcheck::epc::half_plane
