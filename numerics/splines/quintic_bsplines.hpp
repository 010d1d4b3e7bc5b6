#pragma once

#include <array>
#include <vector>

namespace fpkcheck::numerics {

/// B-splines of degree 5 on arbitrary knots, continued as constants beyond the ends, where the
/// first and the last function are 1. de Boor, A Practical Guide to Splines.
class QuinticBSplines {
 public:
  static constexpr int kDegree = 5;

  /// @param knots nondecreasing; multiplicity 6 at the ends, at most 5 inside
  explicit QuinticBSplines(std::vector<double> knots);

  int size() const { return static_cast<int>(knots_.size()) - kDegree - 1; }
  const std::vector<double>& knots() const { return knots_; }
  /// The distinct knots.
  const std::vector<double>& breaks() const { return breaks_; }
  double begin() const { return breaks_.front(); }
  double end() const { return breaks_.back(); }

  /// Values and slopes of the functions first .. first + 5, the only nonzero ones at a point.
  struct Values {
    int first;
    std::array<double, kDegree + 1> value, slope;
  };
  Values at(double x) const;
  /// Second derivatives of the same functions; 0 beyond the ends.
  std::array<double, kDegree + 1> second_derivatives(double x) const;

  /// Coefficients of x^power, 0 <= power <= 5, by Marsden's identity: for each function, the mean
  /// of the products of `power` of its five inner knots.
  std::vector<double> power(int power) const;

 private:
  std::vector<double> knots_, breaks_;
  std::vector<int> first_;  // first nonzero function of each span
};

/// Knots at the given breaks, with multiplicity 6 at both ends.
/// @param multiplicity of the knot at an inner break 0
std::vector<double> knots_from_breaks(const std::vector<double>& breaks, int multiplicity = 1);

/// Graded knots from `begin` to `end`, with multiplicity 6 at both ends. The breaks are evenly
/// spaced from 0 to `uniform_from`. Beyond, where a seventh of all cells lies, the cell widths form
/// a geometric progression. `begin` is 0 or -end.
/// @param cells divisible by 2 where begin is -end
/// @param multiplicity of the knot at 0 when 0 is inside
/// @param shrinking_cells number of cells next to 0, on each side, each narrower than the next by a fifth
std::vector<double> graded_knots(double begin, double end, double uniform_from, int cells,
                                 int multiplicity = 1, int shrinking_cells = 0);

}  // namespace fpkcheck::numerics
