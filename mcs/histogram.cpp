#include "mcs/histogram.hpp"

#include <utility>

namespace fpkcheck::mcs {

BinFinder::BinFinder(std::vector<double> edges) : edges_(std::move(edges)) {
  const std::size_t cells = 2 * bins();
  const double length = edges_.back() - edges_.front();
  cells_per_length_ = static_cast<double>(cells) / length;
  last_cell_ = static_cast<double>(cells - 1);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double lower = edges_.front() + static_cast<double>(cell) / cells_per_length_;
    const auto above = std::upper_bound(edges_.begin(), edges_.end(), lower);
    first_bin_.push_back(static_cast<std::uint32_t>(above - edges_.begin()));
  }
}

std::vector<std::uint64_t> Histogram::row_counts() const {
  std::vector<std::uint64_t> sums(rows());
  for (std::size_t i = 0; i < rows(); ++i) {
    for (std::size_t j = 0; j < columns(); ++j) sums[i] += count(i, j);
  }
  return sums;
}

std::vector<std::uint64_t> Histogram::column_counts() const {
  std::vector<std::uint64_t> sums(columns());
  for (std::size_t i = 0; i < rows(); ++i) {
    for (std::size_t j = 0; j < columns(); ++j) sums[j] += count(i, j);
  }
  return sums;
}

}  // namespace fpkcheck::mcs
