#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fpkcheck::transform {

/// Carries the masses of one set of bins over to another along one axis: the cumulative
/// distribution, known exactly on the source's edges, is interpolated between them by polynomials
/// of degree 7 and differenced on the target's. Where edges coincide nothing is interpolated. No
/// polynomial reaches across 0, where densities of y' may jump at the wall. All mass arrives that
/// is not beyond the target's ends.
///
/// Next to a spike a polynomial swings by more than the bin beside it holds. So of masses that are
/// nowhere negative the interpolated cumulative is kept monotone where it would miss that by more than
/// 1e-6 of the whole, which the tails of a smooth density do not.
class MassTransfer {
 public:
  /// @param source n + 1 increasing edges; target m + 1 increasing edges
  MassTransfer(std::span<const double> source, std::span<const double> target);

  /// @param masses shape (n)
  /// @return shape (m)
  std::vector<double> operator()(std::span<const double> masses) const;

 private:
  /// Below a target edge lie all source bins before `bin` and of that one the sum of weight_k times
  /// the mass of source bin first + k; nothing of it where there are no weights.
  struct Edge {
    std::size_t bin;
    std::size_t first;
    std::vector<double> weights;
  };
  static Edge edge_at(std::span<const double> source, double x);

  std::vector<Edge> edges_;
};

}  // namespace fpkcheck::transform
