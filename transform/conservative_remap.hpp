#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::transform {

/// Conservative remapping of the masses of one set of bins to another set of bins, along one axis.
///
/// The cumulative distribution is known exactly at the source edges, and polynomials of degree 7
/// interpolate the distribution at the target edges. Differences of the distribution between target
/// edges are the new masses, so that the total mass between the ends of the target is conserved. No
/// stencil of interpolation extends across 0, where the density of y' may be discontinuous at the
/// wall.
///
/// Next to a spike, the polynomial overshoots by more than the mass of the adjacent bin. For
/// nonnegative masses, the interpolated distribution is therefore clipped to be monotone wherever
/// its decrease exceeds 1e-6 of the total mass.
class ConservativeRemap {
 public:
  /// @param source n + 1 increasing edges of the old bins
  /// @param target m + 1 increasing edges of the new bins
  ConservativeRemap(std::span<const double> source, std::span<const double> target);

  /// @param masses masses of the old bins, shape (n)
  /// @return masses of the new bins, shape (m)
  std::vector<double> operator()(std::span<const double> masses) const;

 private:
  /// Weights of the source masses in the cumulative distribution at a target edge. The distribution
  /// is the sum of the masses of all source bins before `bin`, plus the sum over k of weights[k]
  /// times the mass of source bin first + k.
  struct EdgeStencil {
    std::size_t bin;
    std::size_t first;
    std::vector<double> weights;
  };
  static EdgeStencil edge_stencil(std::span<const double> source, double x);

  std::vector<EdgeStencil> edges_;
};

}  // namespace fpkcheck::transform
