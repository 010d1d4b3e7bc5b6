#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace fpkcheck::mcs {

/// Checks the edges of bins.
/// @param name name of the edges in messages
/// @throws InputError if there are fewer than two edges, or an edge is infinite or not above the
/// edge before
void require_edges(const std::string& name, const std::vector<double>& edges);

/// Finds the bin that contains a number. The edges of the bins increase and need not be evenly
/// spaced.
class BinFinder {
 public:
  /// @param edges n + 1 increasing numbers, n >= 1
  explicit BinFinder(std::vector<double> edges);

  /// Index of the bin of x: 0 below the first edge, 1 .. n in the half-open bins, n + 1 from the
  /// last edge on.
  std::size_t operator()(double x) const {
    std::size_t bin = first_bin_[static_cast<std::size_t>(cell(x))];
    while (x < guarded_edges_[bin]) --bin;
    while (x >= guarded_edges_[bin + 1]) ++bin;
    return bin;
  }

  /// Whether the edges are evenly spaced up to rounding.
  bool is_evenly_spaced() const { return even_; }
  double first_edge() const { return first_edge_; }
  double bins_per_length() const { return bins_per_length_; }
  /// Distance by which a number on an edge is shifted off this edge: small relative to a bin and
  /// large relative to rounding.
  double edge_epsilon() const { return 1e-13 * (edges_.back() - edges_.front()); }

  std::size_t bin_count() const { return edges_.size() - 1; }
  const std::vector<double>& edges() const { return edges_; }

 private:
  /// Approximate index of the evenly spaced cell that contains x; the index of the first cell for
  /// NaN.
  double cell(double x) const {
    const double from_first = (x - first_edge_) * 2 * bins_per_length_;
    return from_first > 0 ? std::min(from_first, last_cell_) : 0;
  }

  std::vector<double> edges_;
  std::vector<double> guarded_edges_;     // the edges between two NaN
  std::vector<std::uint32_t> first_bin_;  // per evenly spaced cell: bin of its lower end
  double first_edge_;
  double bins_per_length_;
  double last_cell_;
  bool even_;
};

/// Histogram of weighted samples of (y, y') in rectilinear cells. Outer bins hold the samples
/// outside all cells. Row-major, shape (ny + 2, nv + 2).
class Histogram {
 public:
  Histogram(const BinFinder& y, const BinFinder& v)
      : columns_(v.bin_count() + 2), weights_((y.bin_count() + 2) * columns_) {}

  void add(std::size_t row, std::size_t column, double weight) {
    weights_[row * columns_ + column] += weight;
  }

  /// Weight of a bin. Row 0, column 0, the last row and the last column are the outer bins.
  double operator()(std::size_t row, std::size_t column) const {
    return weights_[row * columns_ + column];
  }
  std::size_t rows() const { return weights_.size() / columns_; }
  std::size_t columns() const { return columns_; }

  /// Weights summed over all y', shape (ny + 2), and weights summed over all y, shape (nv + 2).
  std::vector<double> row_sums() const;
  std::vector<double> column_sums() const;

  std::vector<double>& weights() { return weights_; }
  const std::vector<double>& weights() const { return weights_; }

 private:
  std::size_t columns_;
  std::vector<double> weights_;
};

}  // namespace fpkcheck::mcs
