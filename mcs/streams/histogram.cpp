#include "mcs/streams/histogram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "base/input_error.hpp"

namespace fpkcheck::mcs {

void require_increasing_edges(const std::string& name, const std::vector<double>& edges) {
  const bool finite = std::ranges::all_of(edges, [](double x) { return std::isfinite(x); });
  const bool increasing = std::ranges::adjacent_find(edges, std::greater_equal<>{}) == edges.end();
  if (edges.size() > 1 && finite && increasing) return;
  throw InputError(
      fmt::format("{} with {} numbers: bin edges must be two or more finite, increasing numbers; "
                  "correct or omit them",
                  name, edges.size()));
}

BinFinder::BinFinder(std::vector<double> edges)
    : edges_(std::move(edges)), first_edge_(edges_.front()) {
  // A NaN before the first and after the last bin edge stops the bin search in operator(), since
  // comparisons with NaN are false.
  guarded_edges_.push_back(std::numeric_limits<double>::quiet_NaN());
  guarded_edges_.insert(guarded_edges_.end(), edges_.begin(), edges_.end());
  guarded_edges_.push_back(std::numeric_limits<double>::quiet_NaN());
  const std::size_t cells = 2 * bin_count();
  const double width = (edges_.back() - edges_.front()) / static_cast<double>(bin_count());
  bins_per_length_ = 1 / width;
  last_cell_ = static_cast<double>(cells - 1);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double lower = edges_.front() + static_cast<double>(cell) * width / 2;
    const auto above = std::upper_bound(edges_.begin(), edges_.end(), lower);
    first_bin_.push_back(static_cast<std::uint32_t>(above - edges_.begin()));
  }
  even_ = true;
  for (std::size_t k = 0; k <= bin_count(); ++k) {
    const double at = edges_.front() + static_cast<double>(k) * width;
    even_ = even_ && std::abs(edges_[k] - at) < 1e-9 * width;
  }
}

std::vector<double> JointHistogram::row_sums() const {
  std::vector<double> sums(rows());
  for (std::size_t i = 0; i < rows(); ++i) {
    for (std::size_t j = 0; j < columns(); ++j) sums[i] += (*this)(i, j);
  }
  return sums;
}

std::vector<double> JointHistogram::column_sums() const {
  std::vector<double> sums(columns());
  for (std::size_t i = 0; i < rows(); ++i) {
    for (std::size_t j = 0; j < columns(); ++j) sums[j] += (*this)(i, j);
  }
  return sums;
}

}  // namespace fpkcheck::mcs
