#include "epc/half_plane/galerkin_system.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace fpkcheck::epc::half_plane {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

GalerkinSystem::DensityAtPoints GalerkinSystem::evaluate_density(const VectorXd& a) const {
  const ArrayXd exponent = tables_.basis_functions * a + tables_.confinement_terms;
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

VectorXd GalerkinSystem::basis_means(const VectorXd& mass) const {
  return tables_.basis_functions.transpose() * mass;
}

VectorXd GalerkinSystem::residual(const DensityAtPoints& density, std::optional<double> t) const {
  VectorXd rate = tables_.generator_terms.transpose() * density.mass +
                  tables_.impact_terms.transpose() * density.wall_mass;
  if (!t) return rate;
  for (const TimeDependentTerm& term : tables_.time_dependent_terms) {
    rate += term.factor(*t) * (term.values.transpose() * density.mass);
  }
  return rate;
}

MatrixXd GalerkinSystem::centred_basis_functions(const MatrixXd& basis_functions,
                                                 const DensityAtPoints& density) const {
  const Eigen::RowVectorXd mean = density.mass.transpose() * tables_.basis_functions;
  return basis_functions.rowwise() - mean;
}

MatrixXd GalerkinSystem::jacobian(const DensityAtPoints& density, std::optional<double> t) const {
  // d p / d a_k = p (phi_k - E[phi_k]) at the interior points and at the points on the wall.
  const MatrixXd change =
      density.mass.asDiagonal() * centred_basis_functions(tables_.basis_functions, density);
  const MatrixXd wall_change = density.wall_mass.asDiagonal() *
                               centred_basis_functions(tables_.wall_basis_functions, density);
  MatrixXd result(size(), size());
  result.noalias() = tables_.generator_terms.transpose() * change;
  result.noalias() += tables_.impact_terms.transpose() * wall_change;
  if (!t) return result;
  for (const TimeDependentTerm& term : tables_.time_dependent_terms) {
    result.noalias() += term.factor(*t) * (term.values.transpose() * change);
  }
  return result;
}

MatrixXd GalerkinSystem::covariance(const DensityAtPoints& density) const {
  const MatrixXd basis_functions = density.mass.cwiseSqrt().asDiagonal() *
                                   centred_basis_functions(tables_.basis_functions, density);
  MatrixXd result = MatrixXd::Zero(size(), size());
  result.selfadjointView<Eigen::Lower>().rankUpdate(basis_functions.transpose());
  return result.selfadjointView<Eigen::Lower>();
}

VectorXd GalerkinSystem::fit_coefficients(const VectorXd& exponent, const VectorXd& mass) const {
  // The column of ones represents the constant term of the exponent, since Q_n has no constant
  // term.
  MatrixXd columns(tables_.basis_functions.rows(), tables_.basis_functions.cols() + 1);
  columns << VectorXd::Ones(tables_.basis_functions.rows()), tables_.basis_functions;
  const MatrixXd weighted = mass.asDiagonal() * columns;
  const VectorXd solution =
      (columns.transpose() * weighted).ldlt().solve(weighted.transpose() * exponent);
  return solution.tail(size());
}

ClosureDensity make_closure_density(const ClosureEquations& equations, const VectorXd& a,
                                    double level, TailTreatment tail) {
  const GalerkinSystem::DensityAtPoints density = equations.evaluate_density(a);
  const QuadraturePoints& points = equations.points();
  ClosureDensity closure{.q = equations.basis().exponent_polynomial(a),
                         .temperature = density.mass.dot(points.v.cwiseAbs2()),
                         .level = level,
                         .support = support_energy(level, tail)};
  // The constant term of Q_n differs between the basis and the monomials.
  const double constant =
      closure.q(points.s[0], points.t[0]) -
      equations.basis().basis_values(points.s.head(1), points.t.head(1)).row(0).dot(a);
  closure.log_normalisation = density.log_normalisation + constant;
  closure.peak = density.peak + constant;
  return closure;
}

}  // namespace fpkcheck::epc::half_plane
