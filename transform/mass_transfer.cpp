#include "transform/mass_transfer.hpp"

#include <algorithm>

namespace fpkcheck::transform {
namespace {

constexpr std::ptrdiff_t kInterpolationPoints = 8;  // degree 7

/// The share of each source bin's mass that lies below a point: 1 for the first `whole` bins, then
/// `shares`, then 0. Lagrange's interpolation of the cumulative, written for its increments.
struct Below {
  std::size_t whole;
  std::vector<double> shares;

  double operator()(std::size_t bin) const {
    if (bin < whole) return 1;
    return bin - whole < shares.size() ? shares[bin - whole] : 0;
  }
};

Below below(std::span<const double> edges, double x) {
  const auto above = std::ranges::lower_bound(edges, x);
  if (above == edges.end()) return {edges.size() - 1, {}};
  const auto k = above - edges.begin();
  if (*above == x || k == 0) return {static_cast<std::size_t>(k), {}};

  // The edges begin .. end - 1 that a polynomial may join: those on the same side of an edge at 0.
  std::ptrdiff_t begin = 0, end = std::ssize(edges);
  if (const auto zero = std::ranges::lower_bound(edges, 0.0); zero != edges.end() && *zero == 0) {
    if (x > 0) begin = zero - edges.begin();
    if (x < 0) end = zero - edges.begin() + 1;
  }
  const auto points = std::min(kInterpolationPoints, end - begin);
  const auto first = std::clamp(k - points / 2, begin, end - points);

  std::vector<double> lagrange;
  for (auto a = first; a < first + points; ++a) {
    double weight = 1;
    for (auto b = first; b < first + points; ++b) {
      if (b != a) weight *= (x - edges[b]) / (edges[a] - edges[b]);
    }
    lagrange.push_back(weight);
  }
  // The cumulative on edge a counts every bin before a.
  Below result{static_cast<std::size_t>(first), std::vector<double>(points - 1)};
  double sum = 0;
  for (auto a = points - 1; a > 0; --a) result.shares[a - 1] = sum += lagrange[a];
  return result;
}

}  // namespace

MassTransfer::MassTransfer(std::span<const double> source, std::span<const double> target) {
  Below lower = below(source, target.front());
  for (const double edge : target.subspan(1)) {
    Below upper = below(source, edge);
    Row row{std::min(lower.whole, upper.whole), {}};
    const auto end = std::max(lower.whole + lower.shares.size(), upper.whole + upper.shares.size());
    for (auto bin = row.first; bin < end; ++bin) row.weights.push_back(upper(bin) - lower(bin));
    rows_.push_back(std::move(row));
    lower = std::move(upper);
  }
}

std::vector<double> MassTransfer::operator()(std::span<const double> masses) const {
  std::vector<double> result;
  for (const auto& [first, weights] : rows_) {
    double sum = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * masses[first + k];
    result.push_back(sum);
  }
  return result;
}

}  // namespace fpkcheck::transform
