#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace fpkcheck::mcs {

/// Throws InputError unless `edges` are at least two finite, increasing numbers.
/// @param name name of the edges in the error message
void require_increasing_edges(const std::string& name, const std::vector<double>& edges);

/// Search for the bin that contains a number, among bins that may have different widths.
class BinFinder {
 public:
  /// @param edges n + 1 increasing edges of n >= 1 bins
  explicit BinFinder(std::vector<double> edges);

  /// Returns the index of the bin that contains x: 0 below the first edge, 1 .. n between the
  /// edges, n + 1 at or above the last edge.
  std::size_t operator()(double x) const {
    std::size_t bin = first_bin_[static_cast<std::size_t>(histogram_cell_position(x))];
    while (x < guarded_edges_[bin]) --bin;
    while (x >= guarded_edges_[bin + 1]) ++bin;
    return bin;
  }

  bool has_evenly_spaced_bins() const { return even_; }
  double first_edge() const { return first_edge_; }
  double bins_per_unit_length() const { return bins_per_length_; }
  /// Distance by which a number on a bin edge is moved off the edge, small relative to a bin and
  /// large relative to rounding.
  double bin_edge_epsilon() const { return 1e-13 * (edges_.back() - edges_.front()); }

  std::size_t bin_count() const { return edges_.size() - 1; }
  const std::vector<double>& edges() const { return edges_; }

 private:
  /// Returns the approximate index of the search cell that contains x, and 0 for NaN; search cells
  /// are half as wide as the mean bin.
  double histogram_cell_position(double x) const {
    const double from_first = (x - first_edge_) * 2 * bins_per_length_;
    return from_first > 0 ? std::min(from_first, last_cell_) : 0;
  }

  std::vector<double> edges_;
  // bin edges, with a NaN before the first and after the last edge
  std::vector<double> guarded_edges_;
  // for each search cell: index of the bin that contains the lower end of the cell
  std::vector<std::uint32_t> first_bin_;
  double first_edge_;
  double bins_per_length_;
  double last_cell_;
  bool even_;
};

/// Histogram of weighted samples of (y, y'), row-major, shape (ny + 2, nv + 2). The first and last
/// rows and columns of the histogram hold the samples outside the ranges of the bins.
class JointHistogram {
 public:
  JointHistogram(const BinFinder& y, const BinFinder& v)
      : columns_(v.bin_count() + 2), weights_((y.bin_count() + 2) * columns_) {}

  void add(std::size_t row, std::size_t column, double weight) {
    weights_[row * columns_ + column] += weight;
  }

  double operator()(std::size_t row, std::size_t column) const {
    return weights_[row * columns_ + column];
  }
  std::size_t rows() const { return weights_.size() / columns_; }
  std::size_t columns() const { return columns_; }

  /// Row sums are sums over y', shape (ny + 2); column sums are sums over y, shape (nv + 2).
  std::vector<double> row_sums() const;
  std::vector<double> column_sums() const;

  std::vector<double>& histogram_cell_weights() { return weights_; }
  const std::vector<double>& histogram_cell_weights() const { return weights_; }

 private:
  std::size_t columns_;
  std::vector<double> weights_;
};

}  // namespace fpkcheck::mcs
