#pragma once

#include <array>
#include <vector>

namespace fpkcheck::numerics {

/// B-splines of degree 5 on any knots, continued as constants beyond their ends, where the first
/// and the last function are 1. de Boor, A Practical Guide to Splines.
class KnotSplines {
 public:
  static constexpr int kDegree = 5;

  /// @param knots nondecreasing, ends of multiplicity 6, inner knots of at most 5
  explicit KnotSplines(std::vector<double> knots);

  int size() const { return static_cast<int>(knots_.size()) - kDegree - 1; }
  const std::vector<double>& knots() const { return knots_; }
  /// The knots without their repetitions.
  const std::vector<double>& breaks() const { return breaks_; }
  double begin() const { return breaks_.front(); }
  double end() const { return breaks_.back(); }

  /// The functions first .. first + 5, which alone do not vanish at a point.
  struct Values {
    int first;
    std::array<double, kDegree + 1> value, slope;
  };
  Values at(double x) const;
  /// Their second derivatives, 0 beyond the ends.
  std::array<double, kDegree + 1> curvatures(double x) const;

  /// Coefficients of x^power, 0 <= power <= 5, by Marsden's identity: the mean of the products of
  /// `power` of the five inner knots of each function.
  std::vector<double> power(int power) const;

 private:
  std::vector<double> knots_, breaks_;
  std::vector<int> first_;  // of each span
};

/// Knots on the given breaks, six at the ends.
/// @param repetitions of the break at 0, if there is one inside
std::vector<double> knots_on(const std::vector<double>& breaks, int repetitions = 1);

/// Knots from `begin` to `end`, six at the ends, whose breaks are evenly spaced up to `even` from
/// 0 and lie further and further apart beyond, by the same factor from one cell to the next: a
/// seventh of all cells is there. `begin` is 0 or -end.
/// @param cells even where begin is -end
/// @param repetitions of the break at 0 inside
/// @param shrinking how many cells next to 0, on each side, are the narrower by a fifth each
std::vector<double> widening_knots(double begin, double end, double even, int cells,
                                   int repetitions = 1, int shrinking = 0);

}  // namespace fpkcheck::numerics
