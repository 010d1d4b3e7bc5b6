#pragma once

#include <array>
#include <vector>

#include "transform/smooth_bins.hpp"

namespace fpkcheck::mcs {

using transform::SmoothBins;

/// An atom of the amplitude law: the change of velocity and its probability.
struct VelocityShift {
  double by, probability;
};

/// Grid for the deposition of samples (Options::deposit): tensor products B_i(y) B_j(v) of
/// B-splines of degree 5, a lattice of velocities, and smooth bins of both variables.
struct DepositGrid {
  static constexpr int kDegree = 5;
  /// Number of points of the interpolation stencil on the lattice
  static constexpr int kStencil = 8;

  /// Nondecreasing knots of the splines; the knots of y begin at 0. The first and the last knot
  /// have multiplicity 6, inner knots at most 5. Beyond the end knots the splines are constant.
  std::vector<double> y_knots{}, v_knots{};
  /// Lattice of velocities lattice_begin + q lattice_spacing, q = 0 .. lattice_points - 1. A
  /// velocity outside the lattice counts at the nearest end.
  double lattice_begin = 0, lattice_spacing = 1;
  int lattice_points = 0;
  /// Atoms of the law, for laws without a continuous part. K B_j is then a sum of shifted B_j and
  /// is added to the flow exactly, whereas the lattice would interpolate across the knots. If
  /// `shifts` is empty, the lattice is used.
  std::vector<VelocityShift> shifts{};
  SmoothBins y_bins{}, v_bins{};

  int y_spline_count() const { return static_cast<int>(y_knots.size()) - kDegree - 1; }
  int v_spline_count() const { return static_cast<int>(v_knots.size()) - kDegree - 1; }
};

/// Checks a grid.
/// @throws InputError if the grid violates the conditions of DepositGrid
void require_valid_deposit_grid(const DepositGrid& grid);

/// B-splines of degree 5 as polynomials on each span. Rows of eight coefficients hold the six
/// nonzero splines of a span and two zeros.
class SplinePieces {
 public:
  static constexpr int kWidth = 8;

  /// @param knots as in DepositGrid
  explicit SplinePieces(const std::vector<double>& knots);

  double begin() const { return begin_; }
  double end() const { return end_; }
  int spans() const { return static_cast<int>(first_.size()); }
  /// Evenly spaced cells, for the search of the span of a point: no cell is longer than the
  /// shortest span. span_of_cell() has the span at the beginning of each cell.
  double cells_per_length() const { return cells_per_length_; }
  int cells() const { return static_cast<int>(span_of_cell_.size()); }
  const int* span_of_cell() const { return span_of_cell_.data(); }
  /// breaks() has the first point of each span and the end of the last span; reciprocal_lengths()
  /// has the reciprocal length of each span.
  const double* breaks() const { return breaks_.data(); }
  const double* reciprocal_lengths() const { return per_length_.data(); }
  /// For each span, the index of the first nonzero spline.
  const int* first_spline_indices() const { return first_.data(); }
  /// For each span, the offset of its polynomials in coefficients().
  const int* coefficient_offsets() const { return place_.data(); }
  /// Polynomial coefficients of the splines, of shape (11, kWidth) for each span: the coefficients
  /// of t^5, .., 1 with t = (x - begin of the span)/length, then of t^4, .., 1 for the slopes in x.
  /// Spans with equal coefficients share one table.
  const double* coefficients() const { return coefficients_.data(); }

 private:
  double begin_, end_, cells_per_length_;
  std::vector<int> first_, place_, span_of_cell_;
  std::vector<double> breaks_, per_length_, coefficients_;
};

/// A deposition grid with precomputed tables.
struct DepositPlan {
  DepositGrid grid;
  SplinePieces y, v;
  double rate;               ///< impulse rate lambda
  double sampling_interval;  ///< time between samples
  /// Coefficients of t^7, .., 1 of the Lagrange polynomials with nodes -3 .. 4: shape (8, 8).
  std::vector<double> lagrange;
  /// Coefficients of t^3, .., 1 of the four cubics that smooth bins have in a cell: shape (4, 8).
  std::vector<double> cubics;

  /// @throws InputError as require_valid_deposit_grid()
  DepositPlan(const DepositGrid& grid, double rate, double sampling_interval);
};

/// Sums over the samples and impacts of one stream, deposited on a DepositGrid. With N samples at
/// equal intervals over the time T, for any h = sum c_ij B_i(y) B_j(v),
///
///     sum c_ij (flow[i][j] + sum_q lattice[i][q] (K B_j)(v_q)) / N
///         = mean of [ y' h_y + y'' h_v + lambda (K h - h) ]
///           + (1/T) sum over impacts of [ h(0, v+) - h(y-, v-) ].
///
/// With DepositGrid::shifts the lattice stays empty and `flow` includes the terms of the lattice.
/// y'' is the second derivative of the flight's polynomial, (y-, v-) is the state of this
/// polynomial at the impact, and v+ is the velocity after the impact.
struct DepositedSums {
  int flow_pitch = 0, lattice_pitch = 0;
  std::vector<double> flow;     ///< shape (y functions, flow_pitch); rows are padded
  std::vector<double> lattice;  ///< shape (y functions, lattice_pitch); rows are padded
  std::vector<double> y_bins;   ///< sums over samples; smooth bin b of y is at [b + kBinOffset]
  std::vector<double> v_bins;   ///< as y_bins, for y'
  /// Sums of y'', y'' y and y'' y' of the flights' polynomials over samples.
  std::array<double, 3> acceleration{};
  /// Sums of -v-, v+ and |y-| over impacts.
  std::array<double, 3> impacts{};
  /// Sums of 1, Y and Y^2 over the drawn impulses.
  std::array<double, 3> impulses{};

  static constexpr int kBinOffset = 2;

  DepositedSums() = default;
  explicit DepositedSums(const DepositGrid& grid)
      : flow_pitch(grid.v_spline_count() + kPadding),
        lattice_pitch(grid.lattice_points),
        flow(static_cast<std::size_t>(grid.y_spline_count() * flow_pitch)),
        lattice(static_cast<std::size_t>(grid.y_spline_count() * lattice_pitch)),
        y_bins(static_cast<std::size_t>(grid.y_bins.count + 2 * kBinOffset + kPadding)),
        v_bins(static_cast<std::size_t>(grid.v_bins.count + 2 * kBinOffset + kPadding)) {}

 private:
  static constexpr int kPadding = SplinePieces::kWidth;  // sums are updated eight at a time
};

/// Calls `visit` with every member of a deposit that holds sums.
template <class Sums, class Visit>
void for_each_deposit_sum(Sums& deposit, Visit visit) {
  visit(deposit.flow);
  visit(deposit.lattice);
  visit(deposit.y_bins);
  visit(deposit.v_bins);
  visit(deposit.acceleration);
  visit(deposit.impacts);
  visit(deposit.impulses);
}

}  // namespace fpkcheck::mcs
