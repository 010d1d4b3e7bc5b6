#include "backward/generator/backward_equation_fit.hpp"

#include <algorithm>
#include <cmath>

#include "backward/generator/normal_equations.hpp"
#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kMaxSteps = 12;  // largest number of steps of the conjugate gradients
// Convergence threshold of the conjugate gradients: product of gradient and preconditioned
// gradient, relative to the product in the first step. The convergence threshold has the size of
// rounding errors.
constexpr double kConverged = 1e-20;

// Matrix of the least-squares problem, with one row for each collocation point of the backward
// equation. The matrix of the least-squares problem is applied to spline coefficients as a sum of
// three terms, each the product of a factor in y and a factor in v.
class CollocationMatrix {
 public:
  explicit CollocationMatrix(const BackwardEquationFitProblem& p)
      : problem_(p),
        v_functions_(p.velocity_basis.size()),
        constrained_unknowns_(p.velocity_basis.basis_index_at_zero_velocity() + 1),
        functions_per_span_(p.displacement_basis.degree() + 1),
        weights_(static_cast<Eigen::Index>(p.velocity_samples.velocities.size()),
                 static_cast<Eigen::Index>(p.displacement_samples.displacements.size())) {
    for (std::size_t i = 0; i < p.displacement_samples.displacements.size(); ++i) {
      for (std::size_t j = 0; j < p.velocity_samples.velocities.size(); ++j) {
        weights_(j, i) = std::pow(
            p.row_weight(p.displacement_samples.displacements[i], p.velocity_samples.velocities[j]),
            2);
      }
    }
  }

  int y_points() const {
    return static_cast<int>(problem_.displacement_samples.displacements.size());
  }
  int v_points() const { return static_cast<int>(problem_.velocity_samples.velocities.size()); }
  double force(int i) const {
    return problem_.problem.system.restoring_force()(
        problem_.displacement_samples.displacements[i]);
  }

  /// Returns the number of unknown coefficients of the products of each spline of y with the
  /// splines of v. With an impact condition at the wall, the splines b and
  /// basis_index_after_impact(b) of v share one unknown coefficient.
  std::vector<Eigen::Index> block_sizes() const {
    std::vector<Eigen::Index> sizes(problem_.displacement_basis.size(), v_functions_);
    for (std::size_t a : {std::size_t{0}, sizes.size() - 1}) {
      if (is_constrained(static_cast<int>(a))) sizes[a] = constrained_unknowns_;
    }
    return sizes;
  }

  numerics::BlockBandedMatrix normal_matrix() const {
    numerics::BlockBandedMatrix matrix(block_sizes(), problem_.displacement_basis.degree());
    const Eigen::SparseMatrix<double>& drift = problem_.velocity_samples.transport;
    Eigen::MatrixXd motion, weighted;
    for (int i = 0; i < y_points(); ++i) {
      // The generator L maps the spline product A(y) B(v) to A M + A' D, where M =
      // impulse_and_damping + g(y) restoring_force and D = transport.
      motion = problem_.velocity_samples.impulse_and_damping +
               force(i) * problem_.velocity_samples.restoring_force;
      weighted = weights_.col(i).cwiseSqrt().asDiagonal() * motion;
      Eigen::MatrixXd mm = Eigen::MatrixXd::Zero(v_functions_, v_functions_);
      mm.selfadjointView<Eigen::Lower>().rankUpdate(weighted.transpose());
      mm.triangularView<Eigen::StrictlyUpper>() = mm.transpose();
      const Eigen::MatrixXd md =
          (drift.transpose() * (weights_.col(i).asDiagonal() * motion)).transpose();
      const Eigen::MatrixXd dd =
          Eigen::MatrixXd(drift.transpose() * (weights_.col(i).asDiagonal() * drift));
      const Eigen::MatrixXd dm = md.transpose();
      const Eigen::MatrixXd& a = problem_.displacement_samples.values_and_slopes[i];
      for (int l = 0; l < functions_per_span_; ++l) {
        for (int m = 0; m <= l; ++m) {
          const Eigen::MatrixXd block = a(0, l) * a(0, m) * mm + a(0, l) * a(1, m) * md +
                                        a(1, l) * a(0, m) * dm + a(1, l) * a(1, m) * dd;
          add_block(matrix, problem_.displacement_samples.knot_spans[i] + l,
                    problem_.displacement_samples.knot_spans[i] + m, block);
        }
      }
    }
    return matrix;
  }

  /// Returns the values L V of the generator applied to a spline V, at all collocation points,
  /// shape (v points, y points).
  /// @param c spline coefficients of V, shape (functions of y, functions of v)
  Eigen::MatrixXd apply_generator(const Eigen::MatrixXd& c) const {
    const Eigen::MatrixXd jump = problem_.velocity_samples.impulse_and_damping * c.transpose(),
                          drift = problem_.velocity_samples.transport * c.transpose(),
                          force_term = problem_.velocity_samples.restoring_force * c.transpose();
    Eigen::MatrixXd result(v_points(), y_points());
    for (int i = 0; i < y_points(); ++i) {
      const Eigen::MatrixXd& a = problem_.displacement_samples.values_and_slopes[i];
      const int s = problem_.displacement_samples.knot_spans[i];
      result.col(i) = (jump.middleCols(s, functions_per_span_) +
                       force(i) * force_term.middleCols(s, functions_per_span_)) *
                          a.row(0).transpose() +
                      drift.middleCols(s, functions_per_span_) * a.row(1).transpose();
    }
    return result;
  }

  /// Applies the transpose of the matrix of apply_generator() with the squared row weights. Returns
  /// a vector with one element for each unknown coefficient of the normal equations.
  Eigen::VectorXd apply_weighted_transpose(const Eigen::MatrixXd& residual) const {
    const Eigen::MatrixXd weighted = weights_.cwiseProduct(residual);
    Eigen::MatrixXd value = Eigen::MatrixXd::Zero(v_points(), problem_.displacement_basis.size());
    Eigen::MatrixXd forced = value, slope = value;
    for (int i = 0; i < y_points(); ++i) {
      const Eigen::MatrixXd& a = problem_.displacement_samples.values_and_slopes[i];
      const int s = problem_.displacement_samples.knot_spans[i];
      value.middleCols(s, functions_per_span_) += weighted.col(i) * a.row(0);
      forced.middleCols(s, functions_per_span_) += force(i) * weighted.col(i) * a.row(0);
      slope.middleCols(s, functions_per_span_) += weighted.col(i) * a.row(1);
    }
    const Eigen::MatrixXd g = problem_.velocity_samples.impulse_and_damping.transpose() * value +
                              problem_.velocity_samples.restoring_force.transpose() * forced +
                              // shape (functions of v, functions of y)
                              problem_.velocity_samples.transport.transpose() * slope;
    return unknowns_of_gradient(g);
  }

  /// Inner product of two functions at the collocation points with the squared row weights.
  double weighted_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
    return (weights_.array() * a.array() * b.array()).sum();
  }

  /// Returns the spline coefficients c_ab of V for a vector of unknowns.
  Eigen::MatrixXd coefficients_of_unknowns(const Eigen::VectorXd& x) const {
    const int rows = problem_.displacement_basis.size(),
              centre = problem_.velocity_basis.basis_index_at_zero_velocity();
    Eigen::MatrixXd c(rows, v_functions_);
    Eigen::Index first = 0;
    for (int a = 0; a < rows; ++a) {
      if (is_constrained(a)) {
        for (int b = 0; b < constrained_unknowns_; ++b)
          c(a, centre - b) = c(a, centre + b) = x(first + b);
        first += constrained_unknowns_;
      } else {
        c.row(a) = x.segment(first, v_functions_).transpose();
        first += v_functions_;
      }
    }
    return c;
  }

 private:
  // Returns whether V has an impact condition at the wall where a given spline of y is nonzero.
  bool is_constrained(int row) const {
    return (row == 0 && problem_.has_left_impact_condition) ||
           (row == problem_.displacement_basis.size() - 1 && problem_.has_right_impact_condition);
  }

  Eigen::VectorXd unknowns_of_gradient(const Eigen::MatrixXd& g) const {
    const int columns = problem_.displacement_basis.size();
    Eigen::VectorXd x(columns * v_functions_);
    Eigen::Index first = 0;
    for (int a = 0; a < columns; ++a) {
      const Eigen::Index count = is_constrained(a) ? constrained_unknowns_ : v_functions_;
      if (is_constrained(a)) {
        x.segment(first, count) = add_opposite_rows(g.col(a));
      } else {
        x.segment(first, count) = g.col(a);
      }
      first += count;
    }
    x.conservativeResize(first);
    return x;
  }

  // Adds the rows of the splines b and basis_index_after_impact(b) of v, which share one unknown
  // coefficient. The row of the spline of v that is nonzero at v = 0 is added once.
  Eigen::MatrixXd add_opposite_rows(const Eigen::MatrixXd& g) const {
    Eigen::MatrixXd f = g.bottomRows(constrained_unknowns_);
    f.bottomRows(constrained_unknowns_ - 1) +=
        g.topRows(constrained_unknowns_ - 1).colwise().reverse();
    return f;
  }

  // Adds a block of the normal matrix, for the splines `row` and `column` of y.
  void add_block(numerics::BlockBandedMatrix& matrix, int row, int column,
                 const Eigen::MatrixXd& block) const {
    if (!is_constrained(row) && !is_constrained(column)) {
      matrix.block(row, column) += block;
    } else if (!is_constrained(row)) {
      matrix.block(row, column) += add_opposite_rows(block.transpose()).transpose();
    } else if (!is_constrained(column)) {
      matrix.block(row, column) += add_opposite_rows(block);
    } else {
      matrix.block(row, column) +=
          add_opposite_rows(add_opposite_rows(block).transpose()).transpose();
    }
  }

  const BackwardEquationFitProblem& problem_;
  int v_functions_, constrained_unknowns_, functions_per_span_;
  Eigen::MatrixXd weights_;  // squared row weights, shape (v points, y points)
};

/// Minimises the weighted norm of the residual f + L V by conjugate gradients, preconditioned by
/// the factor of the normal equations. Three or four steps of conjugate gradients suffice, except
/// on the finest spline grids, where rounding and the ridge degrade the preconditioner. The
/// conjugate gradients stop at convergence or when rounding prevents progress.
/// @param[in,out] residual on input the functions f, on output the residuals f + L V up to rounding
/// @param[in,out] x on input 0, on output the unknowns of V, one column for each f
void minimise_residuals(const CollocationMatrix& rows, const NormalEquations& equations,
                        std::vector<Eigen::MatrixXd>& residual, Eigen::MatrixXd& x) {
  Eigen::MatrixXd gradient(x.rows(), x.cols()), direction = x;
  Eigen::VectorXd first, last;
  std::vector<bool> ended(residual.size());
  for (int step = 0; step < kMaxSteps && std::ranges::count(ended, false) > 0; ++step) {
    for (Eigen::Index n = 0; n < x.cols(); ++n) {
      gradient.col(n) = -rows.apply_weighted_transpose(residual[static_cast<std::size_t>(n)]);
    }
    const Eigen::MatrixXd preconditioned = equations.solve(gradient);
    const Eigen::VectorXd product = gradient.cwiseProduct(preconditioned).colwise().sum();
    if (step == 0) first = product;
    for (Eigen::Index n = 0; n < x.cols(); ++n) {
      const auto at = static_cast<std::size_t>(n);
      const bool descends =
          product(n) > kConverged * first(n) && (step == 0 || product(n) < last(n));
      if (ended[at] || !descends) {
        ended[at] = true;
        continue;
      }
      direction.col(n) =
          preconditioned.col(n) + (step > 0 ? product(n) / last(n) : 0) * direction.col(n);
      const Eigen::MatrixXd change =
          rows.apply_generator(rows.coefficients_of_unknowns(direction.col(n)));
      const double length = product(n) / rows.weighted_product(change, change);
      x.col(n) += length * direction.col(n);
      residual[at] += length * change;
    }
    last = product;
  }
}

}  // namespace

BackwardEquationSolutions fit_backward_equation_solutions(
    const BackwardEquationFitProblem& fit_problem,
    const std::vector<std::function<double(double, double)>>& integrands) {
  const CollocationMatrix rows(fit_problem);
  const NormalEquations equations(rows.normal_matrix(), "the fit");

  // Right-hand sides of the fit: the integrands f and, in the last column, the constant 1
  const std::size_t count = integrands.size() + 1;
  std::vector<Eigen::MatrixXd> f(count);
  for (std::size_t n = 0; n < count; ++n) {
    f[n] = Eigen::MatrixXd::Ones(rows.v_points(), rows.y_points());
    if (n + 1 == count) break;
    for (int i = 0; i < rows.y_points(); ++i) {
      for (int j = 0; j < rows.v_points(); ++j) {
        f[n](j, i) = integrands[n](fit_problem.displacement_samples.displacements[i],
                                   fit_problem.velocity_samples.velocities[j]);
      }
    }
  }
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(equations.size(), static_cast<Eigen::Index>(count));
  std::vector<Eigen::MatrixXd> residual = f;
  minimise_residuals(rows, equations, residual, x);
  for (std::size_t n = 0; n < count; ++n) {
    residual[n] = f[n] + rows.apply_generator(
                             rows.coefficients_of_unknowns(x.col(static_cast<Eigen::Index>(n))));
  }

  BackwardEquationSolutions solutions;
  const Eigen::MatrixXd& residual_of_one = residual.back();
  for (std::size_t n = 0; n + 1 < count; ++n) {
    const double mean = rows.weighted_product(residual_of_one, residual[n]) /
                        rows.weighted_product(residual_of_one, residual_of_one);
    solutions.mean_estimates.push_back(mean);
    Eigen::MatrixXd c = rows.coefficients_of_unknowns(x.col(n) - mean * x.rightCols<1>());
    // The backward equation L V = U - f determines V only up to a constant, since the generator L
    // maps constants to 0.
    c.array() -= (c.maxCoeff() + c.minCoeff()) / 2;
    solutions.spline_coefficients.push_back(std::move(c));
    const Eigen::MatrixXd final_residual = residual[n] - mean * residual_of_one;
    std::pair<double, double> residual_extremes{0, 0};
    for (int i = 0; i < rows.y_points(); ++i) {
      for (int j = 0; j < rows.v_points(); ++j) {
        const double weighted_residual =
            final_residual(j, i) *
            fit_problem.residual_weight(fit_problem.displacement_samples.displacements[i],
                                        fit_problem.velocity_samples.velocities[j]);
        residual_extremes = {std::min(residual_extremes.first, weighted_residual),
                             std::max(residual_extremes.second, weighted_residual)};
      }
    }
    solutions.residual_extremes.push_back(residual_extremes);
  }
  return solutions;
}

}  // namespace fpkcheck::backward
