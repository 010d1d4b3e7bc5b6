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
class MassTransfer {
 public:
  /// @param source n + 1 increasing edges; target m + 1 increasing edges
  MassTransfer(std::span<const double> source, std::span<const double> target);

  /// @param masses shape (n)
  /// @return shape (m)
  std::vector<double> operator()(std::span<const double> masses) const;

 private:
  /// A bin's mass is the sum of weight_k times the mass of source bin first + k.
  struct Row {
    std::size_t first;
    std::vector<double> weights;
  };
  std::vector<Row> rows_;
};

}  // namespace fpkcheck::transform
