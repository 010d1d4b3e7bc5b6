#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::transform {

/// Conservative remapping of the masses of one set of bins to another set of bins, along one axis.
///
/// The cumulative distribution is known exactly at the edges of the old bins. Polynomials of degree
/// 7 interpolate the cumulative distribution at the edges of the new bins, and the differences of
/// the interpolated values are the masses of the new bins. The total mass between the ends of the
/// new bins is therefore conserved. No interpolation stencil extends across the coordinate 0, since
/// the density of y' may be discontinuous at y' = 0.
///
/// Next to a spike of the density, the interpolating polynomial overshoots by more than the mass of
/// the adjacent bin. If all bin masses are nonnegative, the interpolated cumulative distribution is
/// therefore made monotone wherever the interpolated distribution decreases by more than 1e-6 of
/// the total mass.
class ConservativeRemap {
 public:
  /// @param source_edges n + 1 increasing edges of the old bins
  /// @param target_edges m + 1 increasing edges of the new bins
  ConservativeRemap(std::span<const double> source_edges, std::span<const double> target_edges);

  /// @param masses masses of the old bins, shape (n)
  /// @return masses of the new bins, shape (m)
  std::vector<double> operator()(std::span<const double> masses) const;

 private:
  /// Weights of the masses of the old bins in the cumulative distribution at an edge of the new
  /// bins. The cumulative distribution at an edge of the new bins is the sum of the masses of all
  /// old bins before `bin`, plus the sum over k of weights[k] times the mass of the old bin first +
  /// k.
  struct InterpolationStencil {
    std::size_t bin;
    std::size_t first;
    std::vector<double> weights;
  };
  static InterpolationStencil cumulative_interpolation_stencil(std::span<const double> source_edges,
                                                               double x);

  std::vector<InterpolationStencil> edges_;
};

}  // namespace fpkcheck::transform
