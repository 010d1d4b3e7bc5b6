#pragma once

#include <vector>

#include "transform/smooth_bins.hpp"

namespace fpkcheck::mcs {

using transform::SmoothBins;

/// An atom of the amplitude law.
struct VelocityShift {
  double by, probability;
};

/// Grid for the deposition of samples (Options::deposit): tensor products B_i(y) B_j(v) of
/// B-splines of degree 5, a lattice of velocities, and smooth bins of both variables.
struct DepositGrid {
  static constexpr int kDegree = 5;
  static constexpr int kStencil = 8;  ///< points of the interpolation stencil on the lattice

  /// Nondecreasing knots; those of y begin at 0. The first and last knots have multiplicity 6,
  /// inner knots at most 5. Beyond the ends the splines continue as constants.
  std::vector<double> y_knots{}, v_knots{};
  /// Lattice of velocities begin + q spacing, q = 0 .. points - 1. A velocity outside counts at the
  /// nearest end.
  double lattice_begin = 0, lattice_spacing = 1;
  int lattice_points = 0;
  /// For laws of atoms only: K B_j is a sum of shifted B_j and is added to the flow exactly. The
  /// lattice would interpolate across the knots. Empty: the lattice is used.
  std::vector<VelocityShift> shifts{};
  SmoothBins y_bins{}, v_bins{};

  int y_functions() const { return static_cast<int>(y_knots.size()) - kDegree - 1; }
  int v_functions() const { return static_cast<int>(v_knots.size()) - kDegree - 1; }
};

/// @throws InputError where the grid violates the conditions of DepositGrid
void require_grid(const DepositGrid& grid);

/// B-splines of degree 5 as polynomials on each span, in rows of eight: six splines and two zeros.
class SplinePieces {
 public:
  static constexpr int kWidth = 8;

  /// @param knots as in DepositGrid
  explicit SplinePieces(const std::vector<double>& knots);

  double begin() const { return begin_; }
  double end() const { return end_; }
  int spans() const { return static_cast<int>(first_.size()); }
  /// Evenly spaced cells, none longer than the shortest span, and the span at the beginning of each
  /// cell.
  double cells_per_length() const { return cells_per_length_; }
  int cells() const { return static_cast<int>(span_of_cell_.size()); }
  const int* span_of_cell() const { return span_of_cell_.data(); }
  /// First points of the spans and the last end, and the reciprocal length of each span.
  const double* breaks() const { return breaks_.data(); }
  const double* per_length() const { return per_length_.data(); }
  /// Index of the first spline of each span.
  const int* first() const { return first_.data(); }
  /// Offset of each span in coefficients().
  const int* place() const { return place_.data(); }
  /// Coefficients of t^5, .., 1 with t = (x - begin of the span)/length, then of t^4, .., 1 for the
  /// slopes in x: shape (11, kWidth). Spans with equal coefficients share them.
  const double* coefficients() const { return coefficients_.data(); }

 private:
  double begin_, end_, cells_per_length_;
  std::vector<int> first_, place_, span_of_cell_;
  std::vector<double> breaks_, per_length_, coefficients_;
};

/// A grid with its precomputed tables.
struct DepositPlan {
  DepositGrid grid;
  SplinePieces y, v;
  double rate;               ///< impulse rate lambda
  double sampling_interval;  ///< time between samples
  /// Lagrange polynomials on the points -3 .. 4, coefficients of t^7, .., 1: shape (8, 8).
  std::vector<double> lagrange;
  /// The four cubics of the smooth bins in a cell, coefficients of t^3, .., 1: shape (4, 8).
  std::vector<double> cubics;

  /// @throws InputError as require_grid()
  DepositPlan(const DepositGrid& grid, double rate, double sampling_interval);
};

}  // namespace fpkcheck::mcs
