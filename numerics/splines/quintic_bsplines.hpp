#pragma once

#include <array>
#include <vector>

namespace fpkcheck::numerics {

/// B-splines of degree 5 with arbitrary knots. Beyond each end of the knots every function is
/// constant: the first function is 1 below the lower end, the last function is 1 above the upper
/// end, and all others are 0 there. de Boor, A Practical Guide to Splines.
class QuinticBSplines {
 public:
  static constexpr int kDegree = 5;

  /// @param knots nondecreasing sequence of knots; end knots of multiplicity 6, inner knots of
  /// multiplicity at most 5
  explicit QuinticBSplines(std::vector<double> knots);

  int size() const { return static_cast<int>(knots_.size()) - kDegree - 1; }
  const std::vector<double>& knots() const { return knots_; }
  /// The distinct knots, increasing.
  const std::vector<double>& breaks() const { return breaks_; }
  double begin() const { return breaks_.front(); }
  double end() const { return breaks_.back(); }

  /// Values and slopes at a point of the six basis functions first .. first + 5. All other basis
  /// functions are zero at the point.
  struct ValuesAndSlopes {
    int first;
    std::array<double, kDegree + 1> value, slope;
  };
  ValuesAndSlopes values_and_slopes(double x) const;
  /// Second derivatives at x of the six basis functions that values_and_slopes(x) returns; 0 if x
  /// is beyond an end.
  std::array<double, kDegree + 1> second_derivatives(double x) const;

  /// Coefficients of the function x^power in this basis, 0 <= power <= 5, by Marsden's identity.
  /// The coefficient of a basis function is the mean of all products of `power` different knots
  /// among the five inner knots of the function.
  std::vector<double> coefficients_of_power(int power) const;

 private:
  std::vector<double> knots_, breaks_;
  std::vector<int> first_;  // first nonzero function of each span
};

/// The sequence of knots at the given breaks, with multiplicity 6 at both ends.
/// @param multiplicity multiplicity of the knot at 0, if 0 is an inner break
std::vector<double> knots_from_breaks(const std::vector<double>& breaks, int multiplicity = 1);

/// Graded knots from `begin` to `end`, with multiplicity 6 at both ends. From 0 to `uniform_from`
/// the breaks are evenly spaced. Beyond `uniform_from` the cell widths form a geometric
/// progression; this part has a seventh of all cells. `begin` is 0 or -end.
/// @param cells number of cells; an even number if begin is -end
/// @param multiplicity multiplicity of the knot at 0, if 0 is an inner knot
/// @param shrinking_cells number of cells on each side of 0 whose widths decrease towards 0: each
/// of these cells is narrower by a fifth than its neighbour farther from 0
std::vector<double> graded_knots(double begin, double end, double uniform_from, int cells,
                                 int multiplicity = 1, int shrinking_cells = 0);

}  // namespace fpkcheck::numerics
