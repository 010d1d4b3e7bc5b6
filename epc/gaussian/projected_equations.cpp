#include "epc/gaussian/projected_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "numerics/linear_algebra/factorisations.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

// Degree in x1 and in x2 of the product of a part of the residual F and a projection function. The
// derivative in x2 of the exponent Q_n has degree n-1, and the force has at most degree 5.
constexpr int kForceDegree = numerics::Polynomial::kDegree - 1;
int smooth_integrand_degree(int n) { return std::max(4 * (n - 1), kForceDegree + n - 1) + n; }
int signed_integrand_degree(int n) { return std::max(3 * (n - 1), kForceDegree - 1 + n - 1) + n; }
int impact_integrand_degree(int n) { return n + n; }

PlaneQuadratureRule product_rule(const numerics::QuadratureRule& u1,
                                 const numerics::QuadratureRule& u2,
                                 const StandardDeviations& sigma) {
  PlaneQuadratureRule rule;
  for (std::size_t i = 0; i < u1.points.size(); ++i) {
    for (std::size_t j = 0; j < u2.points.size(); ++j) {
      rule.add_quadrature_point(sigma.x1 * u1.points[i], sigma.x2 * u2.points[j],
                                u1.weights[i] * u2.weights[j]);
    }
  }
  return rule;
}

// Returns the quadrature rule in u on the wall x1 = 0, with int delta(x1) f1(x1) dx1 = f1(0) and
// |x2| = sigma_2 |u|.
PlaneQuadratureRule wall_line_rule(const numerics::QuadratureRule& absolute,
                                   const StandardDeviations& sigma) {
  const double at_wall = 1 / (std::sqrt(2 * std::numbers::pi) * sigma.x1);
  PlaneQuadratureRule rule;
  for (std::size_t j = 0; j < absolute.points.size(); ++j) {
    rule.add_quadrature_point(0, sigma.x2 * absolute.points[j],
                              at_wall * sigma.x2 * absolute.weights[j]);
  }
  return rule;
}

// Returns the nodes of a quadrature rule. If the exponent Q_n is even under (x1, x2) -> (-x1, -x2),
// the residual F of paper (22) is even, and half of the quadrature points suffice.
GaussianProjectionNodes projection_nodes(const PlaneQuadratureRule& rule,
                                         const GaussianWeightedBasis& basis) {
  const bool even = basis.monomial_set() == MonomialSet::point_symmetric;
  return {even ? fold_point_symmetric_rule(rule) : rule, basis};
}

template <class Part>
Eigen::VectorXd values_at_nodes(const GaussianProjectionNodes& nodes, const Eigen::VectorXd& a,
                                const Part& part) {
  const std::vector<ExponentPartialDerivatives> q = nodes.exponent_derivatives(a);
  return Eigen::VectorXd::NullaryExpr(nodes.size(), [&](Eigen::Index i) { return part(i, q[i]); });
}

template <class Gradient>
std::vector<ExponentPartialDerivatives> gradients_at_nodes(const GaussianProjectionNodes& nodes,
                                                           const Eigen::VectorXd& a,
                                                           const Gradient& gradient) {
  std::vector<ExponentPartialDerivatives> q = nodes.exponent_derivatives(a);
  for (Eigen::Index i = 0; i < nodes.size(); ++i) q[i] = gradient(i, q[i]);
  return q;
}

bool has_signed_part(const DensityEquationCoefficients& f) {
  const bool even_force = f.even_force.degree() > 0 || f.even_force.coefficient(0) != 0;
  return even_force || f.rate_times_moment[1] != 0 || f.rate_times_moment[3] != 0;
}

}  // namespace

ProjectedEquations::ProjectedEquations(GaussianWeightedBasis basis,
                                       std::optional<ProjectedFormulaTerms> formulas)
    : basis_(std::move(basis)),
      smooth_(projection_nodes(
          product_rule(numerics::gauss_hermite_rule(smooth_integrand_degree(basis_.order())),
                       numerics::gauss_hermite_rule(smooth_integrand_degree(basis_.order())),
                       basis_.weight_standard_deviations()),
          basis_)),
      signed_(projection_nodes(
          product_rule(
              numerics::normal_rule_weighted_by_sign(signed_integrand_degree(basis_.order())),
              numerics::gauss_hermite_rule(signed_integrand_degree(basis_.order())),
              basis_.weight_standard_deviations()),
          basis_)),
      impact_(projection_nodes(wall_line_rule(numerics::normal_rule_weighted_by_abs(
                                                  impact_integrand_degree(basis_.order())),
                                              basis_.weight_standard_deviations()),
                               basis_)),
      formulas_(std::move(formulas)) {}

ProjectedEquations::ProjectedEquations(GaussianWeightedBasis basis,
                                       const problem::ImpulseTrain& impulses, double jump_radius,
                                       std::optional<ProjectedFormulaTerms> formulas)
    : ProjectedEquations(std::move(basis), std::move(formulas)) {
  jump_.emplace(basis_, impulses, jump_radius);
}

Eigen::VectorXd ProjectedEquations::residual(const DensityEquationCoefficients& f,
                                             const Eigen::VectorXd& a) const {
  Eigen::VectorXd result = projected_residual_without_formulas(f, a);
  if (f.formula_fraction != 0)
    result += f.formula_fraction * formulas_.value().projected_formula_terms(a);
  return result;
}

Eigen::MatrixXd ProjectedEquations::jacobian(const DensityEquationCoefficients& f,
                                             const Eigen::VectorXd& a) const {
  Eigen::MatrixXd result = projected_jacobian_without_formulas(f, a);
  if (f.formula_fraction != 0) result += f.formula_fraction * formulas_.value().jacobian(a);
  return result;
}

Eigen::VectorXd ProjectedEquations::projected_residual_without_formulas(
    const DensityEquationCoefficients& f, const Eigen::VectorXd& a) const {
  if (!f.folded) {
    return smooth_.project_on_basis_functions(
        values_at_nodes(smooth_, a, [&](Eigen::Index i, const ExponentPartialDerivatives& q) {
          return residual_without_wall(f, smooth_.x1(i), smooth_.x2(i), q);
        }));
  }
  Eigen::VectorXd result = smooth_.project_on_basis_functions(
      values_at_nodes(smooth_, a, [&](Eigen::Index i, const ExponentPartialDerivatives& q) {
        return residual_part_without_x1_sign(f, smooth_.x1(i), smooth_.x2(i), q);
      }));
  if (has_signed_part(f)) {
    result += signed_.project_on_basis_functions(
        values_at_nodes(signed_, a, [&](Eigen::Index i, const ExponentPartialDerivatives& q) {
          return residual_part_odd_in_x1_sign(f, signed_.x1(i), q);
        }));
  }
  if (f.jump_fraction != 0) result += f.jump_fraction * jump_.value().projected_remainder(a);
  return result + impact_.project_on_basis_functions(values_at_nodes(
                      impact_, a, [&](Eigen::Index i, const ExponentPartialDerivatives& q) {
                        return impact_residual_part(f, impact_.x2(i), q);
                      }));
}

Eigen::MatrixXd ProjectedEquations::projected_jacobian_without_formulas(
    const DensityEquationCoefficients& f, const Eigen::VectorXd& a) const {
  if (!f.folded) {
    return smooth_.project_gradients_on_basis(
        gradients_at_nodes(smooth_, a, [&](Eigen::Index i, const ExponentPartialDerivatives& q) {
          return residual_without_wall_gradient(f, smooth_.x1(i), smooth_.x2(i), q);
        }));
  }
  Eigen::MatrixXd result = smooth_.project_gradients_on_basis(
      gradients_at_nodes(smooth_, a, [&](Eigen::Index i, const ExponentPartialDerivatives& q) {
        return smooth_residual_gradient(f, smooth_.x1(i), smooth_.x2(i), q);
      }));
  if (has_signed_part(f)) {
    result += signed_.project_gradients_on_basis(
        gradients_at_nodes(signed_, a, [&](Eigen::Index i, const ExponentPartialDerivatives& q) {
          return signed_residual_gradient(f, signed_.x1(i), q);
        }));
  }
  if (f.jump_fraction != 0) result += f.jump_fraction * jump_.value().jacobian(a);
  return result + impact_.project_gradients_on_basis(gradients_at_nodes(
                      impact_, a, [&](Eigen::Index i, const ExponentPartialDerivatives&) {
                        return impact_residual_gradient(f, impact_.x2(i));
                      }));
}

namespace {

using Eigen::VectorXd;

constexpr double kLeastStepFraction = 1e-4;
constexpr double kArmijo = 0.1;

struct ClosureNewtonEquations {
  struct Iterate {
    VectorXd a, residual;
    double size;
  };
  struct Step {
    VectorXd change;
  };

  Iterate at(const VectorXd& a) const {
    const VectorXd residual = projection.residual(f, a);
    return {a, residual, residual.lpNorm<Eigen::Infinity>() / unit};
  }
  Step step(const Iterate& here) const {
    return {-numerics::LuFactors(projection.jacobian(f, here.a)).solve(here.residual)};
  }
  double step_fraction(const Iterate& here, const Step& step) const {
    const double before = here.residual.norm();
    return numerics::halve_step_until_accepted(1, kLeastStepFraction, [&](double step_fraction) {
      const double after = projection.residual(f, here.a + step_fraction * step.change).norm();
      return after < (1 - kArmijo * step_fraction) * before;
    });
  }

  const ProjectedEquations& projection;
  const DensityEquationCoefficients& f;
  double unit;
};

}  // namespace

double unit_of_projected_residual(const ProjectedEquations& projection,
                                  const DensityEquationCoefficients& f) {
  constexpr double kRounding = 1e-4;
  const StandardDeviations& sigma = projection.basis().weight_standard_deviations();
  return std::max(std::abs(f.damping), kRounding * sigma.x2 / sigma.x1);
}

numerics::NewtonResult solve_by_newton(const ProjectedEquations& projection,
                                       const DensityEquationCoefficients& f, const VectorXd& start,
                                       const numerics::NewtonOptions& options) {
  return numerics::solve_by_newton(
      ClosureNewtonEquations{projection, f, unit_of_projected_residual(projection, f)}, start,
      options);
}

}  // namespace fpkcheck::epc::gaussian
