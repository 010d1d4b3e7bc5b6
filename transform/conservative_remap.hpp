#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::transform {

/// Conservative remapping of bin masses from one set of bins to another along one axis.
///
/// The cumulative distribution, exact on the source edges, is interpolated by polynomials of
/// degree 7 and differenced on the target edges. Coinciding edges need no interpolation. No
/// stencil crosses 0, where densities of y' may jump at the wall. All mass within the ends of the
/// target is kept.
///
/// Next to a spike the polynomial overshoots by more than the mass of the adjacent bin. For
/// nonnegative masses the interpolated cumulative is therefore clipped to be monotone wherever it
/// violates monotonicity by more than 1e-6 of the total mass. The tails of a smooth density violate
/// it by less.
class ConservativeRemap {
 public:
  /// @param source n + 1 increasing edges; target m + 1 increasing edges
  ConservativeRemap(std::span<const double> source, std::span<const double> target);

  /// @param masses shape (n)
  /// @return shape (m)
  std::vector<double> operator()(std::span<const double> masses) const;

 private:
  /// The cumulative at a target edge: the masses of all source bins before `bin`, plus the sum of
  /// weight_k times the mass of source bin first + k. Without weights the second part is 0.
  struct Edge {
    std::size_t bin;
    std::size_t first;
    std::vector<double> weights;
  };
  static Edge locate_edge(std::span<const double> source, double x);

  std::vector<Edge> edges_;
};

}  // namespace fpkcheck::transform
