#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace fpkcheck::numerics {

inline constexpr int kDefaultSplineDegree = 6;

/// The B-spline basis of degree p on [breaks.front(), breaks.back()], with simple inner knots and
/// end knots of multiplicity p + 1 (de Boor, A Practical Guide to Splines). On the span from
/// breaks[span] to breaks[span + 1], the B-splines with indices span .. span + p are nonzero and
/// have the sum 1.
class SplineBasis {
 public:
  /// @param breaks at least two break points in increasing order
  explicit SplineBasis(std::vector<double> breaks, int degree = kDefaultSplineDegree);

  int degree() const { return degree_; }
  int break_span_count() const { return static_cast<int>(breaks_.size()) - 1; }
  int size() const { return break_span_count() + degree_; }
  std::span<const double> breaks() const { return breaks_; }
  double end() const { return breaks_.back(); }
  /// Returns knot i, 0 <= i < size() + degree() + 1; each end knot occurs degree() + 1 times.
  double spline_knot(int i) const { return knots_[i]; }
  /// Returns the index of the knot span that contains x, or of the first or last knot span if x is
  /// outside the interval of the breaks.
  int knot_span_containing(double x) const;

  /// Returns the values and derivatives at x of the degree + 1 B-splines that are nonzero on the
  /// given knot span.
  /// @param derivatives highest order of the derivatives
  /// @return matrix of shape (derivatives + 1, degree + 1); row d has the derivatives of order d
  Eigen::MatrixXd basis_derivatives(double x, int span, int derivatives) const;

 private:
  std::vector<double> breaks_, knots_;
  int degree_;
};

/// Returns graded break points 0 = x_0 < .. < x_cells = end. The width of a cell at x is
/// proportional to x + finest near the origin and nearly constant beyond `uniform_from`:
///
///     cell width ~ (x + finest) / (1 + x/uniform_from),   0 < finest < uniform_from.
std::vector<double> graded_break_points(double end, int cells, double finest, double uniform_from);

/// Returns the Bezier extraction matrix, whose row l contains the Bernstein coefficients of basis
/// function span + l on the segment from `from` to `to`. The segment may be a part of the knot
/// span, and `from` may be above `to`. On a segment beyond the knot span, the polynomial of the
/// knot span is extrapolated. Bernstein coefficient j is the blossom (polar form) with p - j
/// arguments `from` and j arguments `to`, computed by de Boor's recursion.
/// @tparam Real type of numbers: double, or an interval type, with which the result contains
/// enclosures of the coefficients
/// @return shape (degree + 1, degree + 1)
template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> bezier_extraction(const SplineBasis& basis,
                                                                      int span, const Real& from,
                                                                      const Real& to) {
  const int p = basis.degree();
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> rows(p + 1, p + 1), d(p + 1, p + 1);
  for (int j = 0; j <= p; ++j) {
    for (int i = 0; i <= p;
         ++i) {  // control point i as a linear combination of the basis functions
      for (int l = 0; l <= p; ++l) d(i, l) = Real(i == l ? 1.0 : 0.0);
    }
    for (int r = 1; r <= p; ++r) {
      const Real argument = r <= p - j ? from : to;
      for (int i = p; i >= r; --i) {
        const Real low = Real(basis.spline_knot(span + i)),
                   high = Real(basis.spline_knot(span + i + p + 1 - r));
        const Real t = (argument - low) / (high - low), s = (high - argument) / (high - low);
        for (int l = i - r; l <= i; ++l) d(i, l) = s * d(i - 1, l) + t * d(i, l);
      }
    }
    for (int l = 0; l <= p; ++l) rows(l, j) = d(p, l);
  }
  return rows;
}

}  // namespace fpkcheck::numerics
