#pragma once

#include <array>
#include <vector>

namespace fpkcheck::numerics {

/// Basis of B-splines of degree 5 with arbitrary knots (de Boor, A Practical Guide to Splines).
/// Below the first knot the first B-spline is 1, and above the last knot the last B-spline is 1.
/// All other B-splines are 0 below the first and above the last knot.
class QuinticBSplines {
 public:
  static constexpr int kDegree = 5;

  /// @param knots nondecreasing sequence of spline knots; end knots of multiplicity 6, inner knots
  /// of multiplicity at most 5
  explicit QuinticBSplines(std::vector<double> knots);

  int size() const { return static_cast<int>(knots_.size()) - kDegree - 1; }
  const std::vector<double>& knots() const { return knots_; }
  /// Returns the distinct knots of the B-splines in increasing order.
  const std::vector<double>& breaks() const { return breaks_; }
  double begin() const { return breaks_.front(); }
  double end() const { return breaks_.back(); }

  /// Values and slopes at a point of the six basis functions that may be nonzero, with the indices
  /// first .. first + 5.
  struct BasisValuesAndSlopes {
    int first;
    std::array<double, kDegree + 1> value, slope;
  };
  BasisValuesAndSlopes values_and_slopes(double x) const;
  /// Returns the second derivatives at x of the six basis functions in values_and_slopes(x). Below
  /// the first and above the last knot the second derivatives are 0.
  std::array<double, kDegree + 1> second_derivatives(double x) const;

  /// Returns the coefficients of the function x^power in the B-spline basis, 0 <= power <= 5, by
  /// Marsden's identity. The coefficient of a B-spline is the mean of all products of `power`
  /// different knots among the five inner knots of the B-spline.
  std::vector<double> coefficients_of_monomial(int power) const;

 private:
  std::vector<double> knots_, breaks_;
  // Index of the first B-spline that is nonzero on each interval between distinct knots
  std::vector<int> first_;
};

/// Returns the knot sequence with the distinct knots `breaks` and end knots of multiplicity 6.
/// @param multiplicity multiplicity of the knot at 0, if 0 is an inner break
std::vector<double> knots_from_breaks(const std::vector<double>& breaks, int multiplicity = 1);

/// Returns graded spline knots from `begin` (0 or -end) to `end`, with end knots of multiplicity 6.
/// From 0 to `uniform_until` the distinct knots are evenly spaced. A seventh of all cells between
/// knots lies beyond `uniform_until`, where the cell widths form a geometric progression.
/// @param cells number of cells between distinct knots, an even number if begin is -end
/// @param multiplicity multiplicity of the knot at 0, if 0 is an inner knot
/// @param shrinking_cells number of cells on each side of 0 whose widths decrease towards 0, by a
/// fifth from each cell to the next
std::vector<double> graded_knots(double begin, double end, double uniform_until, int cells,
                                 int multiplicity = 1, int shrinking_cells = 0);

}  // namespace fpkcheck::numerics
