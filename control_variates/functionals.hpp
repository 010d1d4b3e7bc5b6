#pragma once

#include <array>
#include <vector>

#include "backward/control/control_functions.hpp"
#include "mcs/deposit/deposit.hpp"
#include "mcs/summary.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::control_variates {

/// Exponents of the moment E[y^p y'^q].
struct MomentExponents {
  int p, q;
};
inline constexpr std::array<MomentExponents, 6> kMoments{
    {{1, 0}, {2, 0}, {4, 0}, {0, 1}, {0, 2}, {0, 4}}};

/// The estimated functionals, in this order: moments, smooth bins of y, smooth bins of y'.
struct Functionals {
  transform::SmoothBins y_bins, v_bins;

  int size() const { return static_cast<int>(kMoments.size()) + y_bins.count + v_bins.count; }
  /// The integrands f of all functionals, as functions on the phase plane.
  std::vector<backward::SeparableFunction> integrands() const;
  /// Plain means of the functionals over the samples of one stream.
  std::vector<double> stream_means(const mcs::StreamDeposit& stream) const;
};

}  // namespace fpkcheck::control_variates
