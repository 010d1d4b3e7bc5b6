#include "mcs/streams/histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace fpkcheck::mcs {
namespace {

std::size_t bin_by_linear_search(const std::vector<double>& edges, double x) {
  return static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), x) - edges.begin());
}

TEST(BinFinder, AgreesWithASearchAtAndAroundEveryEdge) {
  std::vector<double> even, uneven;
  for (int k = 0; k <= 140; ++k) {
    even.push_back(-0.7 + 1.4 * k / 140);
    uneven.push_back(std::sinh(-4 + 8.0 * k / 140));
  }
  for (const auto& edges : {even, uneven, std::vector<double>{0, 1}}) {
    const BinFinder bin(edges);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const double next = k + 1 < edges.size() ? edges[k + 1] : edges[k] + 1;
      for (const double x : {std::nextafter(edges[k], -100.0), edges[k], (edges[k] + next) / 2}) {
        EXPECT_EQ(bin(x), bin_by_linear_search(edges, x)) << x;
      }
    }
  }
}

TEST(BinFinder, CountsDistantNumbersInTheOuterBins) {
  const BinFinder bin({0, 1, 2});
  EXPECT_EQ(bin(-1e300), 0u);
  EXPECT_EQ(bin(1e300), 3u);
  EXPECT_EQ(bin(std::numeric_limits<double>::infinity()), 3u);
  EXPECT_EQ(bin(-std::numeric_limits<double>::infinity()), 0u);
  EXPECT_LE(bin(std::numeric_limits<double>::quiet_NaN()), 3u);
  const BinFinder uneven({0, 1, 1e300});
  EXPECT_EQ(uneven(std::numeric_limits<double>::infinity()), 3u);
  EXPECT_LE(uneven(std::numeric_limits<double>::quiet_NaN()), 3u);
}

TEST(BinFinder, DetectsEvenEdges) {
  EXPECT_TRUE(BinFinder({0, 0.1, 0.2, 0.3}).has_evenly_spaced_bins());
  EXPECT_FALSE(BinFinder({0, 0.1, 0.2, 0.31}).has_evenly_spaced_bins());
}

TEST(Histogram, CountsEverySample) {
  const BinFinder y({0, 1, 2}), v({-1, 0, 1});
  JointHistogram histogram(y, v);
  const auto add = [&](double at_y, double at_v) { histogram.add(y(at_y), v(at_v), 0.5); };
  add(0.5, 0.5);
  add(1.5, -0.5);
  add(0.5, 7);
  add(9, -7);
  EXPECT_EQ(histogram(1, 2), 0.5);
  EXPECT_EQ(histogram(2, 1), 0.5);
  EXPECT_EQ(histogram(1, 3), 0.5);
  EXPECT_EQ(histogram(3, 0), 0.5);
  EXPECT_EQ(histogram.row_sums(), (std::vector<double>{0, 1, 0.5, 0.5}));
  EXPECT_EQ(histogram.column_sums(), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
}

}  // namespace
}  // namespace fpkcheck::mcs
