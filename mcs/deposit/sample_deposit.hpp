#pragma once

#include <array>
#include <vector>

#include "transform/smooth_bins.hpp"

namespace fpkcheck::mcs {

using transform::SmoothBins;

/// Atom of the amplitude law: a change of velocity by an impulse, and its probability.
struct VelocityJumpAtom {
  double velocity_change, probability;
};

/// Grid for the deposition of samples (SimulationOptions::deposit): tensor products B_i(y) B_j(v)
/// of B-splines of degree 5, a lattice of velocities, and smooth bins of y and v.
struct SampleDepositionGrid {
  static constexpr int kDegree = 5;
  /// Number of points of the interpolation stencil on the velocity lattice
  static constexpr int kStencil = 8;

  /// Nondecreasing knots of the B-splines; the knots of y begin at 0. The first and the last spline
  /// knot have multiplicity 6, inner knots multiplicity at most 5. The B-splines are constant
  /// outside the interval of their knots.
  std::vector<double> y_knots{}, v_knots{};
  /// Lattice of velocities lattice_begin + q lattice_spacing, q = 0 .. lattice_points - 1. A
  /// velocity outside the velocity lattice is moved to the nearest end of the lattice.
  double lattice_begin = 0, lattice_spacing = 1;
  int lattice_points = 0;
  /// Atoms of an amplitude law without a continuous part; empty for other amplitude laws. For a law
  /// of atoms, the mean K B_j of a spline B_j after an impulse is a sum of shifted splines, which
  /// is added to DepositedSampleSums::flow exactly. For other amplitude laws, interpolation on the
  /// velocity lattice approximates the mean K B_j of a spline B_j after an impulse.
  std::vector<VelocityJumpAtom> velocity_jumps{};
  SmoothBins y_bins{}, v_bins{};

  int y_spline_count() const { return static_cast<int>(y_knots.size()) - kDegree - 1; }
  int v_spline_count() const { return static_cast<int>(v_knots.size()) - kDegree - 1; }
};

/// @throws InputError if the grid violates a condition in the comments of SampleDepositionGrid
void require_valid_deposit_grid(const SampleDepositionGrid& grid);

/// B-splines of degree 5 as polynomials on each knot span. Each row of the coefficient table has
/// eight numbers: the coefficients of the six splines that are nonzero on a knot span, and two
/// zeros.
class SplineSpanPolynomials {
 public:
  static constexpr int kWidth = 8;

  explicit SplineSpanPolynomials(const std::vector<double>& knots);

  double begin() const { return begin_; }
  double end() const { return end_; }
  int break_span_count() const { return static_cast<int>(first_.size()); }
  /// Number of evenly spaced search cells per unit length. Each search cell is at most as long as
  /// the shortest knot span, so that the table span_at_search_cell_begin() gives the knot span of a
  /// point without a search loop.
  double span_search_cells_per_unit_length() const { return cells_per_length_; }
  int cell_count() const { return static_cast<int>(span_of_cell_.size()); }
  const int* span_at_search_cell_begin() const { return span_of_cell_.data(); }
  const double* spline_knots() const { return breaks_.data(); }
  const double* reciprocal_span_lengths() const { return per_length_.data(); }
  const int* first_nonzero_spline_indices() const { return first_.data(); }
  /// Position in the array coefficients() at which the polynomials of each knot span begin
  const int* polynomial_coefficient_offsets() const { return place_.data(); }
  /// Polynomial coefficients of the B-splines, a table of shape (11, kWidth) for each knot span.
  /// The first six table rows are the coefficients of t^5, .., 1 for the values of the splines,
  /// with the coordinate t = (x - begin of the knot span)/length. The last five table rows are the
  /// coefficients of t^4, .., 1 for the derivatives of the splines in x. Knot spans with equal
  /// coefficients share one coefficient table.
  const double* coefficients() const { return coefficients_.data(); }

 private:
  double begin_, end_, cells_per_length_;
  std::vector<int> first_, place_, span_of_cell_;
  std::vector<double> breaks_, per_length_, coefficients_;
};

/// Grid, tables and rates for the deposition of samples, i.e. for sums of splines at the samples.
struct SampleDepositionPlan {
  SampleDepositionGrid grid;
  SplineSpanPolynomials y, v;
  double rate;  ///< mean number lambda of impulses per unit time
  double sampling_interval;
  /// Coefficients of t^7, .., 1 of the Lagrange polynomials with nodes -3 .. 4, shape (8, 8)
  std::vector<double> lagrange;
  /// Coefficients of t^3, .., 1 of the four cubic pieces of smooth bins in a cell, shape (4, 8)
  std::vector<double> cubics;

  /// @throws InputError as require_valid_deposit_grid()
  SampleDepositionPlan(const SampleDepositionGrid& grid, double rate, double sampling_interval);
};

/// Sums over the samples and impacts of one trajectory stream, deposited on a SampleDepositionGrid.
/// For N samples at equal intervals over the time T, and any spline h = sum c_ij B_i(y) B_j(v), the
/// sums `flow` and `lattice` satisfy
///
///     sum c_ij (flow[i][j] + sum_q lattice[i][q] (K B_j)(v_q)) / N
///         = mean of [ y' h_y + y'' h_v + lambda (K h - h) ]
///           + (1/T) sum over impacts of [ h(0, v+) - h(y-, v-) ].
///
/// With SampleDepositionGrid::velocity_jumps, the sums `flow` include the means K B_j, and the sums
/// `lattice` are not used. The acceleration y'' is the second derivative of the flight polynomial,
/// (y-, v-) is the state of the flight polynomial at an impact, and v+ is the velocity after the
/// impact.
struct DepositedSampleSums {
  int flow_pitch = 0, lattice_pitch = 0;
  std::vector<double> flow;     ///< shape (number of splines in y, flow_pitch); rows are padded
  std::vector<double> lattice;  ///< shape (number of splines in y, lattice_pitch); rows are padded
  /// Sums over samples for the smooth bins of y and of y'; bin b has the index b + kBinOffset
  std::vector<double> y_bins;
  std::vector<double> v_bins;
  /// Sums over samples of y'', y'' y and y'' y', with y'' from the flight polynomials
  std::array<double, 3> acceleration{};
  /// Sums over impacts of -v-, v+ and |y-|
  std::array<double, 3> impacts{};
  /// Sums of 1, Y and Y^2 over the drawn impulses with amplitude Y
  std::array<double, 3> impulses{};

  static constexpr int kBinOffset = 2;

  DepositedSampleSums() = default;
  explicit DepositedSampleSums(const SampleDepositionGrid& grid)
      : flow_pitch(grid.v_spline_count() + kPadding),
        lattice_pitch(grid.lattice_points),
        flow(static_cast<std::size_t>(grid.y_spline_count() * flow_pitch)),
        lattice(static_cast<std::size_t>(grid.y_spline_count() * lattice_pitch)),
        y_bins(static_cast<std::size_t>(grid.y_bins.count + 2 * kBinOffset + kPadding)),
        v_bins(static_cast<std::size_t>(grid.v_bins.count + 2 * kBinOffset + kPadding)) {}

 private:
  // number of extra elements at the end of each row of sums, since eight sums are updated at a time
  static constexpr int kPadding = SplineSpanPolynomials::kWidth;
};

/// Calls `visit_deposited_sums` with each array of sums, in the order of checkpoint files.
template <class Sums, class Visit>
void for_each_deposited_sum(Sums& deposit, Visit visit_deposited_sums) {
  visit_deposited_sums(deposit.flow);
  visit_deposited_sums(deposit.lattice);
  visit_deposited_sums(deposit.y_bins);
  visit_deposited_sums(deposit.v_bins);
  visit_deposited_sums(deposit.acceleration);
  visit_deposited_sums(deposit.impacts);
  visit_deposited_sums(deposit.impulses);
}

}  // namespace fpkcheck::mcs
