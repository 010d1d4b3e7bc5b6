#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

inline constexpr int kDefaultSplineDegree = 6;

/// The B-spline basis of degree p on [breaks.front(), breaks.back()], with simple inner knots and
/// end knots of multiplicity p + 1. On the span from breaks[span] to breaks[span + 1], the basis
/// functions with indices span .. span + p are nonzero and their sum is 1. de Boor, A Practical
/// Guide to Splines.
class SplineBasis {
 public:
  /// @param breaks increasing break points, at least two
  explicit SplineBasis(std::vector<double> breaks, int degree = kDefaultSplineDegree);

  int degree() const { return degree_; }
  int span_count() const { return static_cast<int>(breaks_.size()) - 1; }
  /// Number of basis functions, span_count() + degree().
  int size() const { return span_count() + degree_; }
  std::span<const double> breaks() const { return breaks_; }
  double end() const { return breaks_.back(); }
  /// Knot i, 0 <= i < size() + degree() + 1. Each end knot occurs degree() + 1 times.
  double knot(int i) const { return knots_[i]; }
  /// Index of the span that contains x; the first or last span if x is outside the interval of the
  /// breaks.
  int span_containing(double x) const;

  /// Values and derivatives at x of the degree + 1 basis functions that are nonzero on a span.
  /// @param derivatives largest order of derivatives
  /// @return shape (derivatives + 1, degree + 1)
  Eigen::MatrixXd basis_derivatives(double x, int span, int derivatives) const;

 private:
  std::vector<double> breaks_, knots_;
  int degree_;
};

/// Graded break points 0 = x_0 < .. < x_cells = end. Near the origin the cell width is proportional
/// to x + finest. Beyond `uniform_from` the cell width is nearly constant:
///
///     cell width ~ (x + finest) / (1 + x/uniform_from),   0 < finest < uniform_from.
std::vector<double> graded_breaks(double end, int cells, double finest, double uniform_from);

}  // namespace fpkcheck::numerics
