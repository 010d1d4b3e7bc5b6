#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/axes.hpp"
#include "methods/method.hpp"

/// Joint densities that somebody brings along, as a function or as samples, as methods that solve
/// nothing. Where it is said what they are to solve they are closures: judged by their distance to
/// the reference and its error budget, and never the judge.
namespace fpkcheck::methods {

/// What is said of such a density.
struct OwnDensity {
  std::string label;  ///< the solution's id (methods/given/label.hpp)
  /// Nothing: nobody knows, and there is no error budget.
  std::optional<problem::Equation> equation = {};
  problem::Impact impact = problem::Impact::map;  ///< of an equation
  std::size_t place = 0;                          ///< among several, for pictures
};

/// The points at which a function p(y, y') is wanted.
class DensityPoints {
 public:
  /// The cells are those of the axes, and go on with the same widths to 10/7 of them, so that what
  /// lies beyond the axes shows.
  explicit DensityPoints(const compare::ComparisonAxes& axes);

  const std::vector<double>& y_edges() const { return y_edges_; }
  const std::vector<double>& v_edges() const { return v_edges_; }
  /// y = 0, and then three Gauss-Legendre points a cell.
  const std::vector<double>& y() const { return y_; }
  /// Three Gauss-Legendre points a cell.
  const std::vector<double>& v() const { return v_; }

 private:
  std::vector<double> y_edges_, v_edges_, y_, v_;
};

/// How the values of a function are taken.
struct OwnFunction {
  bool normalise = true;  ///< divide by the integral ("normalised_by" says by what)
  /// Of an equation: largest error of p(y) and of p(y') in L1, as its residuals measure it, with
  /// which it is ok.
  double accuracy = 0.02;
};

/// A function, from its values; as averages over the cells of the points. Its status is
/// `inadmissible` where values are negative, where it is cut off at the last edge, or where it is
/// not normalised and its integral is not 1.
/// @param values row-major, shape (points.y(), points.v())
/// @throws InputError when a value is not finite, or the integral is not positive
Method own_function(const OwnDensity& own, const OwnFunction& how, const DensityPoints& points,
                    std::vector<double> values);

/// Samples, as a histogram over the cells of the comparison axes, with 95 % intervals and the
/// errors by chance that are those of independent ones.
/// @param y, v of each sample
/// @param independent how many independent ones they are worth; 0: all of them
/// @throws InputError when they are fewer than 100, of different numbers, not finite, or behind the
///         wall; when more are said to be independent than there are
Method own_samples(const OwnDensity& own, std::span<const double> y, std::span<const double> v,
                   double independent = 0);

}  // namespace fpkcheck::methods
