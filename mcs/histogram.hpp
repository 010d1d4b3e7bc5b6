#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace fpkcheck::mcs {

/// Finds the bin of a number among increasing edges, evenly spaced or not.
class BinFinder {
 public:
  /// @param edges n + 1 increasing numbers, n >= 1
  explicit BinFinder(std::vector<double> edges);

  /// 0 below the first edge, 1 .. n for the half-open bins, n + 1 from the last edge on.
  std::size_t operator()(double x) const {
    const double cell = std::clamp((x - edges_.front()) * cells_per_length_, 0.0, last_cell_);
    std::size_t bin = first_bin_[static_cast<std::size_t>(cell)];
    while (bin > 0 && x < edges_[bin - 1]) --bin;
    while (bin < edges_.size() && x >= edges_[bin]) ++bin;
    return bin;
  }

  std::size_t bins() const { return edges_.size() - 1; }
  const std::vector<double>& edges() const { return edges_; }

 private:
  std::vector<double> edges_;
  std::vector<std::uint32_t> first_bin_;  // bin of the lower end of each of evenly spaced cells
  double cells_per_length_;
  double last_cell_;
};

/// Counts of (y, y') over rectilinear cells, and around them a frame for what falls outside, so
/// that nothing is lost. Row-major, shape (ny + 2, nv + 2).
class Histogram {
 public:
  Histogram(const BinFinder& y, const BinFinder& v)
      : y_(&y), v_(&v), columns_(v.bins() + 2), counts_((y.bins() + 2) * columns_) {}

  void add(double y, double v) { ++counts_[(*y_)(y)*columns_ + (*v_)(v)]; }

  /// Row and column 0 and the last ones are the frame.
  std::uint64_t count(std::size_t row, std::size_t column) const {
    return counts_[row * columns_ + column];
  }
  std::size_t rows() const { return y_->bins() + 2; }
  std::size_t columns() const { return columns_; }

  /// Counts of y whatever y', shape (ny + 2), and of y' whatever y, shape (nv + 2).
  std::vector<std::uint64_t> row_counts() const;
  std::vector<std::uint64_t> column_counts() const;

 private:
  const BinFinder* y_;
  const BinFinder* v_;
  std::size_t columns_;
  std::vector<std::uint64_t> counts_;
};

}  // namespace fpkcheck::mcs
