#pragma once

#include <array>
#include <vector>

#include "mcs/deposit/grid.hpp"

namespace fpkcheck::mcs {

/// What the samples and impacts of one stream put on a DepositGrid, as sums. With N samples an
/// interval apart, for any h = sum c_ij B_i(y) B_j(v),
///
///     sum c_ij (flow[i][j] + sum_q lattice[i][q] (K B_j)(v_q)) / N
///         = mean of [ y' h_y + y'' h_v + lambda (K h - h) ]
///           + (1/T) sum over impacts of [ h(0, v+) - h(y-, v-) ],
///
/// (with DepositGrid::shifts the lattice stays empty and the flow has all of it), where y'' is the
/// second derivative of the flight's own polynomial, y- and v- are where that polynomial was at the
/// impact, and v+ is the velocity that the motion went on with.
struct Deposit {
  int flow_pitch = 0, lattice_pitch = 0;
  std::vector<double> flow;     ///< shape (y functions, flow_pitch), the v functions first
  std::vector<double> lattice;  ///< shape (y functions, lattice_pitch), the points first
  std::vector<double> y_bins;   ///< smooth bin b at [b + kFrame]
  std::vector<double> v_bins;   ///< likewise
  /// y'' y'^0, y'' y, y'' y' of the flights' polynomials.
  std::array<double, 3> acceleration{};
  /// Sums over impacts: of -v-, of v+, of |y-|.
  std::array<double, 3> impacts{};
  /// Of the impulses as they were drawn: 1, Y, Y^2.
  std::array<double, 3> impulses{};

  static constexpr int kFrame = 2;

  Deposit() = default;
  explicit Deposit(const DepositGrid& grid)
      : flow_pitch(grid.v_functions() + kOverhang),
        lattice_pitch(grid.lattice_points),
        flow(static_cast<std::size_t>(grid.y_functions() * flow_pitch)),
        lattice(static_cast<std::size_t>(grid.y_functions() * lattice_pitch)),
        y_bins(static_cast<std::size_t>(grid.y_bins.count + 2 * kFrame + kOverhang)),
        v_bins(static_cast<std::size_t>(grid.v_bins.count + 2 * kFrame + kOverhang)) {}

 private:
  static constexpr int kOverhang = SplinePieces::kWidth;  // eight numbers are added at a time
};

/// Shows every sum of a deposit to `visit`.
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
