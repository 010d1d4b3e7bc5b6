#pragma once

#include <array>
#include <vector>

#include "mcs/deposit/deposit_grid.hpp"

namespace fpkcheck::mcs {

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
