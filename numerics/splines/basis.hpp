#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

inline constexpr int kDefaultSplineDegree = 6;

/// B-splines of degree p on [breaks.front(), breaks.back()] with simple inner knots and end knots
/// of multiplicity p + 1. On the span from breaks[span] to breaks[span + 1] the functions span ..
/// span + p are nonzero and sum to 1. de Boor, A Practical Guide to Splines.
class SplineBasis {
 public:
  /// @param breaks increasing, at least two
  explicit SplineBasis(std::vector<double> breaks, int degree = kDefaultSplineDegree);

  int degree() const { return degree_; }
  int spans() const { return static_cast<int>(breaks_.size()) - 1; }
  /// Number of functions, spans() + degree().
  int size() const { return spans() + degree_; }
  std::span<const double> breaks() const { return breaks_; }
  double end() const { return breaks_.back(); }
  /// Knot i of size() + degree() + 1; the end knots are repeated.
  double knot(int i) const { return knots_[i]; }
  /// The span that contains x; the first or last span when x is outside.
  int span_of(double x) const;

  /// Values and derivatives at x of the degree + 1 functions of a span.
  /// @return shape (derivatives + 1, degree + 1)
  Eigen::MatrixXd at(double x, int span, int derivatives) const;

 private:
  std::vector<double> breaks_, knots_;
  int degree_;
};

/// Graded break points 0 = x_0 < .. < x_cells = end. Near the origin the cell width is proportional
/// to x + finest; beyond `uniform_from` it is nearly constant:
///
///     cell width ~ (x + finest) / (1 + x/uniform_from),   0 < finest < uniform_from.
std::vector<double> graded_breaks(double end, int cells, double finest, double uniform_from);

}  // namespace fpkcheck::numerics
