#include "backward/control_variates/control_variate_functions.hpp"

#include <algorithm>

#include "backward/control_variates/generator_factors.hpp"
#include "backward/generator/normal_equations.hpp"
#include "numerics/linear_algebra/factorisations.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kDegree = numerics::QuinticBSplines::kDegree;
constexpr int kPoints = 8;  // number of points of the Gauss rule on a cell

/// Multiplies the weights of a quadrature rule by the values of a weight function.
void apply_weight(numerics::QuadratureRule& q, const std::function<double(double)>& weight) {
  for (std::size_t n = 0; n < q.points.size(); ++n) {
    q.weights(static_cast<Eigen::Index>(n)) *= weight(q.points[n]);
  }
}

/// Gram matrices of the weighted inner products of generator factors, one for each pair of factors.
using GramMatrices = std::vector<std::vector<Eigen::MatrixXd>>;

GramMatrices gram_matrices(const GeneratorFactors& factors, const Eigen::VectorXd& weights) {
  GramMatrices g(factors.size(), std::vector<Eigen::MatrixXd>(factors.size()));
  for (std::size_t a = 0; a < factors.size(); ++a) {
    const Eigen::MatrixXd weighted = weights.asDiagonal() * factors[a];
    for (std::size_t b = 0; b <= a; ++b) {
      g[a][b].noalias() = weighted.transpose() * factors[b];
      if (b < a) g[b][a] = g[a][b].transpose();
    }
  }
  return g;
}

Eigen::VectorXd values_at_points(const std::vector<double>& points,
                                 const std::function<double(double)>& f) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(points.size()));
  for (std::size_t n = 0; n < points.size(); ++n) {
    values(static_cast<Eigen::Index>(n)) = f(points[n]);
  }
  return values;
}

/// Returns the Gram matrix int u w(wall, u) J J^T du of the jumps J_j(u) = B_j(r u) - B_j(-u) of
/// the splines at impacts, mirrored at a right wall.
Eigen::MatrixXd wall_jump_gram_matrix(const ControlVariateFitProblem& p,
                                      const WallWithRestitution& wall) {
  numerics::QuadratureRule q =
      numerics::composite_gauss_rule<kPoints>(impact_speed_breaks(p.v_splines, wall));
  apply_weight(q, [&](double u) { return u * p.v_weight(u); });
  const Eigen::MatrixXd jump = spline_jumps_at_impacts(p.v_splines, wall, q.points);
  return p.y_weight(wall.position) * (jump.transpose() * (q.weights.asDiagonal() * jump));
}

numerics::BlockBandedMatrix control_normal_matrix(const ControlVariateFitProblem& p,
                                                  const GramMatrices& y_gram_matrices,
                                                  const GramMatrices& v_gram_matrices) {
  const Eigen::Index n = p.v_splines.size();
  numerics::BlockBandedMatrix matrix(
      std::vector<Eigen::Index>(static_cast<std::size_t>(p.y_splines.size()), n), kDegree);
  for (int column = 0; column < p.y_splines.size(); ++column) {
    for (int row = column; row < std::min(column + kDegree + 1, p.y_splines.size()); ++row) {
      auto block = matrix.block(row, column);
      for (std::size_t a = 0; a < y_gram_matrices.size(); ++a) {
        for (std::size_t b = 0; b < y_gram_matrices.size(); ++b)
          block += y_gram_matrices[a][b](row, column) * v_gram_matrices[a][b];
      }
    }
  }
  // At a wall only one spline of y is nonzero, and its value is 1.
  for (const WallWithRestitution& wall : walls_with_restitution(p.problem.system)) {
    const int at = wall.rebound_sign > 0 ? 0 : p.y_splines.size() - 1;
    matrix.block(at, at) += p.wall_jump_weight * wall_jump_gram_matrix(p, wall);
  }
  return matrix;
}

}  // namespace

ControlVariateFunctions fit_control_variate_functions(
    const ControlVariateFitProblem& fit_problem, const std::vector<SeparableFunction>& integrands) {
  numerics::QuadratureRule y_rule = numerics::composite_gauss_rule<kPoints>(
                               fit_problem.y_splines.breaks()),
                           v_rule = numerics::composite_gauss_rule<kPoints>(
                               fit_problem.v_splines.breaks());
  apply_weight(y_rule, fit_problem.y_weight);
  apply_weight(v_rule, fit_problem.v_weight);
  const GeneratorFactors y = displacement_generator_factors(fit_problem.problem.system,
                                                            fit_problem.y_splines, y_rule.points);
  const GeneratorFactors v = velocity_generator_factors(
      fit_problem.problem, fit_problem.v_splines, v_rule.points,
      spline_means_after_impulse(fit_problem.v_splines, fit_problem.problem.impulses,
                                 v_rule.points));
  const NormalEquations equations(
      control_normal_matrix(fit_problem, gram_matrices(y, y_rule.weights),
                            gram_matrices(v, v_rule.weights)),
      "the control functions");

  // Right-hand sides -<f, L A_i B_j> of the normal equations for each integrand f, and for the
  // constant 1 in the last column.
  const auto constant_one = [](double) { return 1.0; };
  std::vector<SeparableFunction> all(integrands);
  all.push_back({constant_one, constant_one});
  const auto count = static_cast<Eigen::Index>(all.size());
  const Eigen::Index nv = fit_problem.v_splines.size();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(equations.size(), count);
  std::vector<double> integrals;  // weighted integral int w f dy dv of each function f
  for (Eigen::Index f = 0; f < count; ++f) {
    const auto& [y_factor, v_factor] = all[static_cast<std::size_t>(f)];
    const Eigen::VectorXd wy =
        y_rule.weights.cwiseProduct(values_at_points(y_rule.points, y_factor));
    const Eigen::VectorXd wv =
        v_rule.weights.cwiseProduct(values_at_points(v_rule.points, v_factor));
    integrals.push_back(wy.sum() * wv.sum());
    Eigen::Map<Eigen::MatrixXd> b(right.col(f).data(), nv, fit_problem.y_splines.size());
    for (std::size_t a = 0; a < y.size(); ++a) {
      b.noalias() -= (v[a].transpose() * wv) * (y[a].transpose() * wy).transpose();
    }
  }
  ControlVariateFunctions result;
  result.spline_coefficients = equations.solve(right);
  // The residual e_f of the fit to an integrand f is orthogonal to L h for every spline h.
  // Therefore the residuals satisfy <e_1, e_f> = <1, f> + <1, L h_f>, where the last column of
  // -right contains the products <1, L A B>.
  const Eigen::VectorXd products = result.spline_coefficients.transpose() * right.rightCols<1>();
  const double residual_norm_of_one = integrals.back() - products(count - 1);
  for (Eigen::Index f = 0; f + 1 < count; ++f) {
    const double mean =
        (integrals[static_cast<std::size_t>(f)] - products(f)) / residual_norm_of_one;
    result.mean_estimates.push_back(mean);
    result.spline_coefficients.col(f) -= mean * result.spline_coefficients.col(count - 1);
  }
  result.spline_coefficients.conservativeResize(Eigen::NoChange, count - 1);
  return result;
}

}  // namespace fpkcheck::backward
