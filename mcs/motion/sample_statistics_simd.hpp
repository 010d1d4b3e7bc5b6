#pragma once

#include "mcs/motion/taylor_flight.hpp"
#include "mcs/streams/trajectory_stream.hpp"
#include "numerics/simd/simd.hpp"

// sample_statistics_simd.hpp adds samples in SIMD lanes to moments and histograms, and is compiled
// for several instruction sets.
namespace fpkcheck::mcs {
namespace {

template <class Number, int W>
struct alignas(64) SimdLaneArray {
  Number at[W];
};

/// Returns the position of x among evenly spaced edges, in bin widths; the integer part of the
/// position is the index of the bin. For a number x within rounding of a bin edge, the bin index
/// may be the index of either neighbouring bin.
template <class Real>
FPKCHECK_INLINE Real bin_position(const BinFinder& bins, const Real& x) {
  return simd::lanewise_min(
      simd::lanewise_max((x - bins.first_edge()) * bins.bins_per_unit_length() + 1.0, Real{}),
      simd::all_lanes_equal_to<Real>(static_cast<double>(bins.bin_count() + 1)));
}

/// Adds the weighted monomials y^p v^q of a state (y, v), with the exponents kRecordedMomentPowers,
/// to `powers`.
template <class Real>
FPKCHECK_INLINE void add_weighted_monomials(const PhaseState<Real>& at, const Real& sample_weight,
                                            Real (&powers)[kRecordedMomentPowers.size()]) {
  const Real x = at.y, u = at.v;
  const Real xx = x * x, xu = x * u, uu = u * u;
  const Real terms[] = {x,      u,      xx,      xu,      uu,      x * xx,  xx * u,
                        x * uu, u * uu, xx * xx, xx * xu, xx * uu, xu * uu, uu * uu};
#pragma GCC unroll 16
  for (std::size_t p = 0; p < kRecordedMomentPowers.size(); ++p) {
    powers[p] = powers[p] + sample_weight * terms[p];
  }
}

/// Adds the sample weights of the SIMD lanes to the histograms of the trajectory streams.
/// @param y positions between the walls
/// @param cells cells of the histogram of each trajectory stream
template <int W, class Real>
FPKCHECK_INLINE void add_lane_samples_to_histograms(const BinFinder& y_bins,
                                                    const BinFinder& v_bins, const Real& y,
                                                    const Real& v, const Real& sample_weight,
                                                    TrajectoryStream* const* streams,
                                                    double* const (&cells)[W]) {
  if (y_bins.has_evenly_spaced_bins() && v_bins.has_evenly_spaced_bins()) {
    const auto row = simd::truncate_to_index(bin_position(y_bins, y));
    // The sign of v selects the bin next to the bin edge v = 0, even for v = 0 up to rounding. Near
    // rest the density has a spike at v = 0, and each of the two bins at v = 0 contains half of the
    // spike.
    const Real bin_edge_epsilon = simd::all_lanes_equal_to<Real>(v_bins.bin_edge_epsilon());
    const Real off_zero = simd::select(v < 0.0, simd::lanewise_min(v, -bin_edge_epsilon),
                                       simd::lanewise_max(v, bin_edge_epsilon));
    const auto column = simd::truncate_to_index(bin_position(v_bins, off_zero));
    const auto cell = row * static_cast<std::int32_t>(v_bins.bin_count() + 2) + column;
    SimdLaneArray<std::int32_t, W> cell_of;
    SimdLaneArray<double, W> weights;
    __builtin_memcpy(&cell_of, &cell, sizeof cell);
    simd::store(sample_weight, weights.at);
#pragma GCC unroll 8
    for (int i = 0; i < W; ++i) cells[i][cell_of.at[i]] += weights.at[i];
  } else {
    for (int i = 0; i < W; ++i) {
      streams[i]->record.histogram.add(y_bins(simd::value_in_lane(y, i)),
                                       v_bins(simd::value_in_lane(v, i)),
                                       simd::value_in_lane(sample_weight, i));
    }
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
