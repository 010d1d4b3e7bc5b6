#include "backward/generator/least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "backward/generator/normal_equations.hpp"
#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kMaxSteps = 12;
// Convergence threshold of the product of gradient and preconditioned gradient, relative to the
// product in the first step. The threshold has the size of rounding errors.
constexpr double kConverged = 1e-20;

// Matrix of the least-squares problem, applied to vectors as a sum of three separable terms.
class FitRows {
 public:
  explicit FitRows(const LeastSquaresProblem& p)
      : p_(p),
        functions_(p.velocity.size()),
        constrained_size_(p.velocity.centre_index() + 1),
        per_span_(p.displacement.degree() + 1),
        weights_(static_cast<Eigen::Index>(p.v.v.size()), static_cast<Eigen::Index>(p.y.y.size())) {
    for (std::size_t i = 0; i < p.y.y.size(); ++i) {
      for (std::size_t j = 0; j < p.v.v.size(); ++j) {
        weights_(j, i) = std::pow(p.row_weight(p.y.y[i], p.v.v[j]), 2);
      }
    }
  }

  int y_points() const { return static_cast<int>(p_.y.y.size()); }
  int v_points() const { return static_cast<int>(p_.v.v.size()); }
  double force(int i) const { return p_.problem.system.restoring_force()(p_.y.y[i]); }

  /// Returns the numbers of unknowns of each spline of y. At a wall the two functions of a mirrored
  /// pair share one unknown.
  std::vector<Eigen::Index> block_sizes() const {
    std::vector<Eigen::Index> sizes(p_.displacement.size(), functions_);
    for (std::size_t a : {std::size_t{0}, sizes.size() - 1}) {
      if (is_constrained(static_cast<int>(a))) sizes[a] = constrained_size_;
    }
    return sizes;
  }

  numerics::BlockBandedMatrix normal_matrix() const {
    numerics::BlockBandedMatrix matrix(block_sizes(), p_.displacement.degree());
    const Eigen::SparseMatrix<double>& drift = p_.v.drift;
    Eigen::MatrixXd motion, weighted;
    for (int i = 0; i < y_points(); ++i) {
      // generator L = A M + A' D with M = jump + g(y) force and D = drift
      motion = p_.v.jump + force(i) * p_.v.force;
      weighted = weights_.col(i).cwiseSqrt().asDiagonal() * motion;
      Eigen::MatrixXd mm = Eigen::MatrixXd::Zero(functions_, functions_);
      mm.selfadjointView<Eigen::Lower>().rankUpdate(weighted.transpose());
      mm.triangularView<Eigen::StrictlyUpper>() = mm.transpose();
      const Eigen::MatrixXd md =
          (drift.transpose() * (weights_.col(i).asDiagonal() * motion)).transpose();
      const Eigen::MatrixXd dd =
          Eigen::MatrixXd(drift.transpose() * (weights_.col(i).asDiagonal() * drift));
      const Eigen::MatrixXd dm = md.transpose();
      const Eigen::MatrixXd& a = p_.y.values[i];
      for (int l = 0; l < per_span_; ++l) {
        for (int m = 0; m <= l; ++m) {
          const Eigen::MatrixXd block = a(0, l) * a(0, m) * mm + a(0, l) * a(1, m) * md +
                                        a(1, l) * a(0, m) * dm + a(1, l) * a(1, m) * dd;
          add(matrix, p_.y.span[i] + l, p_.y.span[i] + m, block);
        }
      }
    }
    return matrix;
  }

  /// Returns the values L V of the generator applied to a spline V, at all collocation points,
  /// shape (v points, y points).
  /// @param c coefficients of V, shape (functions of y, functions of v)
  Eigen::MatrixXd apply(const Eigen::MatrixXd& c) const {
    const Eigen::MatrixXd jump = p_.v.jump * c.transpose(), drift = p_.v.drift * c.transpose(),
                          force_term = p_.v.force * c.transpose();
    Eigen::MatrixXd result(v_points(), y_points());
    for (int i = 0; i < y_points(); ++i) {
      const Eigen::MatrixXd& a = p_.y.values[i];
      const int s = p_.y.span[i];
      result.col(i) =
          (jump.middleCols(s, per_span_) + force(i) * force_term.middleCols(s, per_span_)) *
              a.row(0).transpose() +
          drift.middleCols(s, per_span_) * a.row(1).transpose();
    }
    return result;
  }

  /// Applies the weighted transpose of apply(); returns a vector of the unknowns of the normal
  /// equations.
  Eigen::VectorXd apply_transpose(const Eigen::MatrixXd& residual) const {
    const Eigen::MatrixXd weighted = weights_.cwiseProduct(residual);
    Eigen::MatrixXd value = Eigen::MatrixXd::Zero(v_points(), p_.displacement.size());
    Eigen::MatrixXd forced = value, slope = value;
    for (int i = 0; i < y_points(); ++i) {
      const Eigen::MatrixXd& a = p_.y.values[i];
      const int s = p_.y.span[i];
      value.middleCols(s, per_span_) += weighted.col(i) * a.row(0);
      forced.middleCols(s, per_span_) += force(i) * weighted.col(i) * a.row(0);
      slope.middleCols(s, per_span_) += weighted.col(i) * a.row(1);
    }
    const Eigen::MatrixXd g = p_.v.jump.transpose() * value + p_.v.force.transpose() * forced +
                              // shape (functions of v, functions of y)
                              p_.v.drift.transpose() * slope;
    return unknowns_of_gradient(g);
  }

  double dot(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
    return (weights_.array() * a.array() * b.array()).sum();
  }

  Eigen::MatrixXd coefficients_of_unknowns(const Eigen::VectorXd& x) const {
    const int rows = p_.displacement.size(), centre = p_.velocity.centre_index();
    Eigen::MatrixXd c(rows, functions_);
    Eigen::Index first = 0;
    for (int a = 0; a < rows; ++a) {
      if (is_constrained(a)) {
        for (int b = 0; b < constrained_size_; ++b)
          c(a, centre - b) = c(a, centre + b) = x(first + b);
        first += constrained_size_;
      } else {
        c.row(a) = x.segment(first, functions_).transpose();
        first += functions_;
      }
    }
    return c;
  }

 private:
  bool is_constrained(int row) const {
    return (row == 0 && p_.has_impact_condition_at_begin) ||
           (row == p_.displacement.size() - 1 && p_.has_impact_condition_at_end);
  }

  Eigen::VectorXd unknowns_of_gradient(const Eigen::MatrixXd& g) const {
    const int columns = p_.displacement.size();
    Eigen::VectorXd x(columns * functions_);
    Eigen::Index first = 0;
    for (int a = 0; a < columns; ++a) {
      const Eigen::Index count = is_constrained(a) ? constrained_size_ : functions_;
      if (is_constrained(a)) {
        x.segment(first, count) = add_mirrored_rows(g.col(a));
      } else {
        x.segment(first, count) = g.col(a);
      }
      first += count;
    }
    x.conservativeResize(first);
    return x;
  }

  // Adds the rows of mirrored functions; the row of the central function has no mirror image and
  // counts once.
  Eigen::MatrixXd add_mirrored_rows(const Eigen::MatrixXd& g) const {
    Eigen::MatrixXd f = g.bottomRows(constrained_size_);
    f.bottomRows(constrained_size_ - 1) += g.topRows(constrained_size_ - 1).colwise().reverse();
    return f;
  }

  void add(numerics::BlockBandedMatrix& matrix, int row, int column,
           const Eigen::MatrixXd& block) const {
    if (!is_constrained(row) && !is_constrained(column)) {
      matrix.block(row, column) += block;
    } else if (!is_constrained(row)) {
      matrix.block(row, column) += add_mirrored_rows(block.transpose()).transpose();
    } else if (!is_constrained(column)) {
      matrix.block(row, column) += add_mirrored_rows(block);
    } else {
      matrix.block(row, column) +=
          add_mirrored_rows(add_mirrored_rows(block).transpose()).transpose();
    }
  }

  const LeastSquaresProblem& p_;
  int functions_, constrained_size_, per_span_;
  Eigen::MatrixXd weights_;  // squared weights, shape (v points, y points)
};

/// Minimises |residual + A x| by conjugate gradients, preconditioned by the factor of the normal
/// equations. Three or four steps suffice, except on the finest grids, where rounding and the ridge
/// degrade the preconditioner. The iteration stops at convergence or when rounding prevents
/// progress.
/// @param residual, x initial values with x = 0; at the end the residuals equal f + A x up to
/// rounding
void minimise(const FitRows& rows, const NormalEquations& equations,
              std::vector<Eigen::MatrixXd>& residual, Eigen::MatrixXd& x) {
  Eigen::MatrixXd gradient(x.rows(), x.cols()), direction = x;
  Eigen::VectorXd first, last;
  std::vector<bool> ended(residual.size());
  for (int step = 0; step < kMaxSteps && std::ranges::count(ended, false) > 0; ++step) {
    for (Eigen::Index n = 0; n < x.cols(); ++n) {
      gradient.col(n) = -rows.apply_transpose(residual[static_cast<std::size_t>(n)]);
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
      const Eigen::MatrixXd change = rows.apply(rows.coefficients_of_unknowns(direction.col(n)));
      const double length = product(n) / rows.dot(change, change);
      x.col(n) += length * direction.col(n);
      residual[at] += length * change;
    }
    last = product;
  }
}

}  // namespace

BackwardSolutions solve_backward_equations(
    const LeastSquaresProblem& problem,
    const std::vector<std::function<double(double, double)>>& functions) {
  const FitRows rows(problem);
  const NormalEquations equations(rows.normal_matrix(), "the fit");

  // Right-hand sides of the fit: the integrand f of each functional, and the constant 1 in the last
  // place.
  const std::size_t count = functions.size() + 1;
  std::vector<Eigen::MatrixXd> f(count);
  for (std::size_t n = 0; n < count; ++n) {
    f[n] = Eigen::MatrixXd::Ones(rows.v_points(), rows.y_points());
    if (n + 1 == count) break;
    for (int i = 0; i < rows.y_points(); ++i) {
      for (int j = 0; j < rows.v_points(); ++j) {
        f[n](j, i) = functions[n](problem.y.y[i], problem.v.v[j]);
      }
    }
  }
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(equations.size(), static_cast<Eigen::Index>(count));
  std::vector<Eigen::MatrixXd> residual = f;
  minimise(rows, equations, residual, x);
  for (std::size_t n = 0; n < count; ++n) {
    residual[n] =
        f[n] + rows.apply(rows.coefficients_of_unknowns(x.col(static_cast<Eigen::Index>(n))));
  }

  BackwardSolutions solutions;
  const Eigen::MatrixXd& one = residual.back();
  for (std::size_t n = 0; n + 1 < count; ++n) {
    const double mean = rows.dot(one, residual[n]) / rows.dot(one, one);
    solutions.means.push_back(mean);
    Eigen::MatrixXd c = rows.coefficients_of_unknowns(x.col(n) - mean * x.rightCols<1>());
    // The equation L V = U - f determines V up to a constant, since the generator L maps constants
    // to 0.
    c.array() -= (c.maxCoeff() + c.minCoeff()) / 2;
    solutions.coefficients.push_back(std::move(c));
    const Eigen::MatrixXd left = residual[n] - mean * one;
    std::pair<double, double> residual_extremes{0, 0};
    for (int i = 0; i < rows.y_points(); ++i) {
      for (int j = 0; j < rows.v_points(); ++j) {
        const double weighted_residual =
            left(j, i) * problem.residual_weight(problem.y.y[i], problem.v.v[j]);
        residual_extremes = {std::min(residual_extremes.first, weighted_residual),
                             std::max(residual_extremes.second, weighted_residual)};
      }
    }
    solutions.residual_extremes.push_back(residual_extremes);
  }
  return solutions;
}

}  // namespace fpkcheck::backward
