#pragma once

#include <vector>

#include "transform/smooth_bins.hpp"

namespace fpkcheck::mcs {

using transform::SmoothBins;

/// An amplitude that impulses have with a positive probability.
struct VelocityShift {
  double by, probability;
};

/// Where a simulation deposits its samples (Options::deposit): tensor products B_i(y) B_j(v) of
/// B-splines of degree 5, a lattice of velocities, and smooth bins of both variables.
struct DepositGrid {
  static constexpr int kDegree = 5;
  static constexpr int kStencil = 8;  ///< points of the interpolation on the lattice

  /// Nondecreasing knots, the first and last of multiplicity 6, inner ones of at most 5, those of y
  /// from 0. Beyond the ends the splines go on as constants.
  std::vector<double> y_knots{}, v_knots{};
  /// Velocities begin + q spacing, q = 0 .. points - 1; a velocity beyond them counts at their end.
  double lattice_begin = 0, lattice_spacing = 1;
  int lattice_points = 0;
  /// For laws that have such amplitudes alone: K B_j is then a sum of shifted B_j, which goes into
  /// the flow exactly, where the lattice would interpolate over their knots. Empty: the lattice.
  std::vector<VelocityShift> shifts{};
  SmoothBins y_bins{}, v_bins{};

  int y_functions() const { return static_cast<int>(y_knots.size()) - kDegree - 1; }
  int v_functions() const { return static_cast<int>(v_knots.size()) - kDegree - 1; }
};

/// @throws InputError when the grid is not as described above
void require_grid(const DepositGrid& grid);

/// B-splines of degree 5 as polynomials on each span, eight at a time (six, and two that are 0).
class SplinePieces {
 public:
  static constexpr int kWidth = 8;

  /// @param knots as DepositGrid has them
  explicit SplinePieces(const std::vector<double>& knots);

  double begin() const { return begin_; }
  double end() const { return end_; }
  int spans() const { return static_cast<int>(first_.size()); }
  /// Evenly spaced cells, none longer than the shortest span, and the span in which each begins.
  double cells_per_length() const { return cells_per_length_; }
  int cells() const { return static_cast<int>(span_of_cell_.size()); }
  const int* span_of_cell() const { return span_of_cell_.data(); }
  /// Begins of the spans and the last end, and one over the length of each span.
  const double* breaks() const { return breaks_.data(); }
  const double* per_length() const { return per_length_.data(); }
  /// Of each span the first of its functions.
  const int* first() const { return first_.data(); }
  /// Of each span where its coefficients begin.
  const int* place() const { return place_.data(); }
  /// Coefficients of t^5, .., 1, t = (x - begin of the span)/length, then those of the slopes in x
  /// of t^4, .., 1: shape (11, kWidth). Spans that look alike share them.
  const double* coefficients() const { return coefficients_.data(); }

 private:
  double begin_, end_, cells_per_length_;
  std::vector<int> first_, place_, span_of_cell_;
  std::vector<double> breaks_, per_length_, coefficients_;
};

/// A grid made ready for samples.
struct DepositPlan {
  DepositGrid grid;
  SplinePieces y, v;
  double rate;               ///< lambda
  double sampling_interval;  ///< time between samples
  /// Lagrange's polynomials on the points -3 .. 4, coefficients of t^7, .., 1: shape (8, 8).
  std::vector<double> lagrange;
  /// The four cubics of the smooth bins on a cell, coefficients of t^3, .., 1: shape (4, 8).
  std::vector<double> cubics;

  /// @throws InputError as require_grid()
  DepositPlan(const DepositGrid& grid, double rate, double sampling_interval);
};

}  // namespace fpkcheck::mcs
