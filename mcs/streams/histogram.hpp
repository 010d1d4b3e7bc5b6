#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace fpkcheck::mcs {

/// @param name how messages call the edges
/// @throws InputError unless these are two or more finite numbers, each larger than the one before
void require_edges(const std::string& name, const std::vector<double>& edges);

/// Finds the bin of a number among increasing edges, evenly spaced or not.
class BinFinder {
 public:
  /// @param edges n + 1 increasing numbers, n >= 1
  explicit BinFinder(std::vector<double> edges);

  /// 0 below the first edge, 1 .. n for the half-open bins, n + 1 from the last edge on.
  std::size_t operator()(double x) const {
    std::size_t bin = first_bin_[static_cast<std::size_t>(cell(x))];
    while (x < fenced_[bin]) --bin;
    while (x >= fenced_[bin + 1]) ++bin;
    return bin;
  }

  /// The edges are evenly spaced but for rounding.
  bool even() const { return even_; }
  double first_edge() const { return first_edge_; }
  double bins_per_length() const { return bins_per_length_; }
  /// Narrow for a bin, and wide for rounding: numbers further apart are told apart by arithmetic.
  double hair() const { return 1e-13 * (edges_.back() - edges_.front()); }

  std::size_t bins() const { return edges_.size() - 1; }
  const std::vector<double>& edges() const { return edges_; }

 private:
  /// Which of the evenly spaced cells x is in, roughly. Of what is no number it is the first.
  double cell(double x) const {
    const double from_first = (x - first_edge_) * 2 * bins_per_length_;
    return from_first > 0 ? std::min(from_first, last_cell_) : 0;
  }

  std::vector<double> edges_;
  std::vector<double> fenced_;            // the edges between two guards
  std::vector<std::uint32_t> first_bin_;  // bin of the lower end of each of evenly spaced cells
  double first_edge_;
  double bins_per_length_;
  double last_cell_;
  bool even_;
};

/// Weights of samples of (y, y') over rectilinear cells, and around them a frame for what falls
/// outside, so that nothing is lost. Row-major, shape (ny + 2, nv + 2).
class Histogram {
 public:
  Histogram(const BinFinder& y, const BinFinder& v)
      : columns_(v.bins() + 2), weights_((y.bins() + 2) * columns_) {}

  void add(std::size_t row, std::size_t column, double weight) {
    weights_[row * columns_ + column] += weight;
  }

  /// Row and column 0 and the last ones are the frame.
  double operator()(std::size_t row, std::size_t column) const {
    return weights_[row * columns_ + column];
  }
  std::size_t rows() const { return weights_.size() / columns_; }
  std::size_t columns() const { return columns_; }

  /// Sums of y whatever y', shape (ny + 2), and of y' whatever y, shape (nv + 2).
  std::vector<double> row_sums() const;
  std::vector<double> column_sums() const;

  std::vector<double>& weights() { return weights_; }
  const std::vector<double>& weights() const { return weights_; }

 private:
  std::size_t columns_;
  std::vector<double> weights_;
};

}  // namespace fpkcheck::mcs
