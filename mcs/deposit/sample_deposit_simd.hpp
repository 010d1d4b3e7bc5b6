#pragma once

#include <cstdint>

#include "mcs/deposit/sample_deposit.hpp"
#include "numerics/simd/simd.hpp"

// sample_deposit_simd.hpp is compiled for several instruction sets. Each SIMD lane holds one of the
// splines that are nonzero at a sample; in all other files of mcs/ each SIMD lane holds one
// trajectory stream.

namespace fpkcheck::mcs {
namespace {

using Real8 = simd::SimdVectorTypes<8>::Real;

template <int kDegree>
FPKCHECK_INLINE Real8 evaluate_polynomials(const double* coefficients, double t) {
  Real8 sum = simd::load<Real8>(coefficients);
#pragma GCC unroll 8
  for (int n = 1; n <= kDegree; ++n) sum = sum * t + simd::load<Real8>(coefficients + 8 * n);
  return sum;
}

FPKCHECK_INLINE void add_to_eight_sums(double* to, const Real8& terms) {
  simd::store(simd::load<Real8>(to) + terms, to);
}

/// Values and slopes of the six B-splines that are nonzero at a point, with the index `first` of
/// the first of the six B-splines.
struct SplineValuesAndSlopes {
  Real8 value, slope;
  int first;
};

FPKCHECK_INLINE SplineValuesAndSlopes evaluate_splines(const SplineSpanPolynomials& pieces,
                                                       double x) {
  // A coordinate x that is NaN is replaced by the first spline knot.
  const double inside = x > pieces.begin() ? (x < pieces.end() ? x : pieces.end()) : pieces.begin();
  const int place =
      static_cast<int>((inside - pieces.begin()) * pieces.span_search_cells_per_unit_length());
  const int last = pieces.cell_count() - 1;
  // Each search cell contains at most one spline knot. At a spline knot the polynomials of the two
  // neighbouring knot spans agree up to rounding.
  int span = pieces.span_at_search_cell_begin()[place > last ? last : place];
  span += span + 1 < pieces.break_span_count() && inside >= pieces.spline_knots()[span + 1] ? 1 : 0;
  const double* const c = pieces.coefficients() + pieces.polynomial_coefficient_offsets()[span];
  const double t = (inside - pieces.spline_knots()[span]) * pieces.reciprocal_span_lengths()[span];
  SplineValuesAndSlopes f{evaluate_polynomials<5>(c, t), Real8{},
                          pieces.first_nonzero_spline_indices()[span]};
  // Outside the interval of the knots the B-splines are constant, with slope 0.
  if (inside == x) f.slope = evaluate_polynomials<4>(c + 6 * 8, t);
  return f;
}

/// Adds a weighted sample x to the sums of the smooth bins whose B-splines are nonzero at x.
FPKCHECK_INLINE void add_to_smooth_bins(const SmoothBins& bins, const double* cubics, double* sums,
                                        double x, double weight) {
  const double cells = (x - bins.first) / bins.spacing;
  if (!(cells >= -1.0 && cells < bins.count)) return;
  const int cell = static_cast<int>(cells + 1.0) - 1;
  add_to_eight_sums(sums + cell - 1 + DepositedSampleSums::kBinOffset,
                    weight * evaluate_polynomials<3>(cubics, cells - cell));
}

/// Adds lambda B_i(y), for the impulse rate lambda and the splines B_i(y), to the points of the
/// velocity lattice next to v, by Lagrange interpolation with eight points.
FPKCHECK_INLINE void deposit_on_velocity_lattice(const SampleDepositionPlan& plan,
                                                 DepositedSampleSums& deposit, int first,
                                                 const Real8& rates, double v) {
  const SampleDepositionGrid& grid = plan.grid;
  double cells = (v - grid.lattice_begin) / grid.lattice_spacing;
  const double last = grid.lattice_points - 1;
  cells = cells > 0 ? (cells < last ? cells : last) : 0;
  int cell = static_cast<int>(cells);
  cell = cell < 3 ? 3 : cell > grid.lattice_points - 5 ? grid.lattice_points - 5 : cell;
  const Real8 stencil = evaluate_polynomials<7>(plan.lagrange.data(), cells - cell);
  double* line = deposit.lattice.data() + first * deposit.lattice_pitch + cell - 3;
#pragma GCC unroll 6
  for (int i = 0; i < 6; ++i) {
    add_to_eight_sums(line, simd::value_in_lane(rates, i) * stencil);
    line += deposit.lattice_pitch;
  }
}

/// Adds the terms of one sample (y, v) to the sums of DepositedSampleSums.
/// @param acceleration second derivative y'' of the flight polynomial
FPKCHECK_INLINE void deposit_sample(const SampleDepositionPlan& plan, DepositedSampleSums& deposit,
                                    double y, double v, double acceleration, double weight) {
  const SplineValuesAndSlopes in_y = evaluate_splines(plan.y, y),
                              in_v = evaluate_splines(plan.v, v);
  // Terms y' B_i' B_j - lambda B_i B_j + y'' B_i B_j' of one sample for splines B_i(y) and B_j(v)
  const Real8 of_value = (weight * v) * in_y.slope - (weight * plan.rate) * in_y.value;
  const Real8 of_slope = (weight * acceleration) * in_y.value;
  double* row = deposit.flow.data() + in_y.first * deposit.flow_pitch + in_v.first;
#pragma GCC unroll 6
  for (int i = 0; i < 6; ++i) {
    add_to_eight_sums(row, simd::value_in_lane(of_value, i) * in_v.value +
                               simd::value_in_lane(of_slope, i) * in_v.slope);
    row += deposit.flow_pitch;
  }
  const SampleDepositionGrid& grid = plan.grid;
  const Real8 rates = (weight * plan.rate) * in_y.value;
  if (grid.velocity_jumps.empty()) {
    deposit_on_velocity_lattice(plan, deposit, in_y.first, rates, v);
  } else {
    for (const VelocityJumpAtom& atom : grid.velocity_jumps) {
      const SplineValuesAndSlopes after = evaluate_splines(plan.v, v + atom.velocity_change);
      double* line = deposit.flow.data() + in_y.first * deposit.flow_pitch + after.first;
#pragma GCC unroll 6
      for (int i = 0; i < 6; ++i) {
        add_to_eight_sums(line, (simd::value_in_lane(rates, i) * atom.probability) * after.value);
        line += deposit.flow_pitch;
      }
    }
  }
  add_to_smooth_bins(grid.y_bins, plan.cubics.data(), deposit.y_bins.data(), y, weight);
  add_to_smooth_bins(grid.v_bins, plan.cubics.data(), deposit.v_bins.data(), v, weight);
  const double weighted = weight * acceleration;
  deposit.acceleration[0] += weighted;
  deposit.acceleration[1] += weighted * y;
  deposit.acceleration[2] += weighted * v;
}

/// Deposits the jump h(0, v+) - h(y-, v-) of a spline h(y, v) at one impact, to first order in the
/// displacement y-, since y- differs from 0 only by rounding.
FPKCHECK_INLINE void deposit_impact(const SampleDepositionPlan& plan, DepositedSampleSums& deposit,
                                    double y_before, double v_before, double v_after,
                                    double weight) {
  const double per_sample = weight / plan.sampling_interval;
  const SplineValuesAndSlopes before = evaluate_splines(plan.v, v_before),
                              after = evaluate_splines(plan.v, v_after);
  const SplineValuesAndSlopes wall = evaluate_splines(plan.y, 0.0);
  double* row = deposit.flow.data();
  add_to_eight_sums(row + after.first, per_sample * after.value);
#pragma GCC unroll 2
  // at the wall y = 0 only the first two splines of y have a nonzero value or slope
  for (int i = 0; i < 2; ++i) {
    const double at =
        simd::value_in_lane(wall.value, i) + y_before * simd::value_in_lane(wall.slope, i);
    add_to_eight_sums(row + before.first, (-per_sample * at) * before.value);
    row += deposit.flow_pitch;
  }
  deposit.impacts[0] -= weight * v_before;
  deposit.impacts[1] += weight * v_after;
  deposit.impacts[2] += weight * (y_before < 0 ? -y_before : y_before);
}

}  // namespace
}  // namespace fpkcheck::mcs
