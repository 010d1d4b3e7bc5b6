#include "backward/control/control_functions.hpp"

#include <algorithm>

#include "backward/control/generator_factors.hpp"
#include "backward/generator/normal_equations.hpp"
#include "numerics/linear_algebra/factorisations.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kDegree = numerics::QuinticBSplines::kDegree;
constexpr int kPoints = 8;  // number of points of the Gauss rule on a cell

void apply_weight(numerics::QuadratureRule& q, const std::function<double(double)>& weight) {
  for (std::size_t n = 0; n < q.points.size(); ++n) {
    q.weights(static_cast<Eigen::Index>(n)) *= weight(q.points[n]);
  }
}

/// Weighted inner products <factor a, factor b> of all pairs of factors.
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

/// Returns the Gram matrix int u w(wall, u) J J^T du of the jumps J_j(u) = B_j(r u) - B_j(-u),
/// mirrored at a right wall.
Eigen::MatrixXd wall_gram(const ControlFitProblem& p, const ImpactWall& wall) {
  numerics::QuadratureRule q =
      numerics::composite_gauss_rule<kPoints>(non_smooth_impact_speeds(p.v, wall));
  apply_weight(q, [&](double u) { return u * p.weight_v(u); });
  const Eigen::MatrixXd jump = spline_jumps_at_impacts(p.v, wall, q.points);
  return p.weight_y(wall.position) * (jump.transpose() * (q.weights.asDiagonal() * jump));
}

numerics::BlockBandedMatrix normal_matrix(const ControlFitProblem& p, const GramMatrices& in_y,
                                          const GramMatrices& in_v) {
  const Eigen::Index n = p.v.size();
  numerics::BlockBandedMatrix matrix(
      std::vector<Eigen::Index>(static_cast<std::size_t>(p.y.size()), n), kDegree);
  for (int column = 0; column < p.y.size(); ++column) {
    for (int row = column; row < std::min(column + kDegree + 1, p.y.size()); ++row) {
      auto block = matrix.block(row, column);
      for (std::size_t a = 0; a < in_y.size(); ++a) {
        for (std::size_t b = 0; b < in_y.size(); ++b) block += in_y[a][b](row, column) * in_v[a][b];
      }
    }
  }
  // At a wall only one spline of y is nonzero, with the value 1.
  for (const ImpactWall& wall : impact_walls(p.problem.system)) {
    const int at = wall.rebound_sign > 0 ? 0 : p.y.size() - 1;
    matrix.block(at, at) += p.wall_weight * wall_gram(p, wall);
  }
  return matrix;
}

}  // namespace

ControlFunctions fit_control_functions(const ControlFitProblem& problem,
                                       const std::vector<SeparableFunction>& functions) {
  numerics::QuadratureRule in_y = numerics::composite_gauss_rule<kPoints>(problem.y.breaks()),
                           in_v = numerics::composite_gauss_rule<kPoints>(problem.v.breaks());
  apply_weight(in_y, problem.weight_y);
  apply_weight(in_v, problem.weight_v);
  const GeneratorFactors y =
      displacement_generator_factors(problem.problem.system, problem.y, in_y.points);
  const GeneratorFactors v = velocity_generator_factors(
      problem.problem, problem.v, in_v.points,
      spline_means_after_impulse(problem.v, problem.problem.impulses, in_v.points));
  const NormalEquations equations(
      normal_matrix(problem, gram_matrices(y, in_y.weights), gram_matrices(v, in_v.weights)),
      "the control functions");

  // Right-hand sides -<f, L A_i B_j> of the normal equations for each function f, and for the
  // constant 1 in the last column.
  const auto constant_one = [](double) { return 1.0; };
  std::vector<SeparableFunction> all(functions);
  all.push_back({constant_one, constant_one});
  const auto count = static_cast<Eigen::Index>(all.size());
  const Eigen::Index nv = problem.v.size();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(equations.size(), count);
  std::vector<double> integrals;  // weighted integral int w f of each function f
  for (Eigen::Index f = 0; f < count; ++f) {
    const auto& [y_factor, v_factor] = all[static_cast<std::size_t>(f)];
    const Eigen::VectorXd wy = in_y.weights.cwiseProduct(values_at_points(in_y.points, y_factor));
    const Eigen::VectorXd wv = in_v.weights.cwiseProduct(values_at_points(in_v.points, v_factor));
    integrals.push_back(wy.sum() * wv.sum());
    Eigen::Map<Eigen::MatrixXd> b(right.col(f).data(), nv, problem.y.size());
    for (std::size_t a = 0; a < y.size(); ++a) {
      b.noalias() -= (v[a].transpose() * wv) * (y[a].transpose() * wy).transpose();
    }
  }
  ControlFunctions result;
  result.coefficients = equations.solve(right);
  // The residual e_f of the fit to f is orthogonal to L h for every spline h. Therefore <e_1, e_f>
  // = <1, f> + <1, L h_f>, where the last column of -right contains the products <1, L A B>.
  const Eigen::VectorXd products = result.coefficients.transpose() * right.rightCols<1>();
  const double of_one = integrals.back() - products(count - 1);
  for (Eigen::Index f = 0; f + 1 < count; ++f) {
    const double mean = (integrals[static_cast<std::size_t>(f)] - products(f)) / of_one;
    result.means.push_back(mean);
    result.coefficients.col(f) -= mean * result.coefficients.col(count - 1);
  }
  result.coefficients.conservativeResize(Eigen::NoChange, count - 1);
  return result;
}

}  // namespace fpkcheck::backward
