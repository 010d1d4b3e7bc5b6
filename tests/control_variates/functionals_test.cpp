#include "control_variates/control_setup.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::control_variates {
namespace {

constexpr transform::SmoothBins kBins{.first = -0.2, .spacing = 0.2, .count = 8};

TEST(Functionals, AreWhatTheDepositHolds) {
  const Functionals functionals{.y_bins = kBins, .v_bins = {-1, 0.5, 5}};
  const auto functions = functionals.integrands();
  EXPECT_EQ(static_cast<int>(functions.size()), functionals.size());
  mcs::StreamDeposit stream;
  stream.samples = 4;
  for (std::size_t p = 0; p < mcs::kPowers.size(); ++p)
    stream.powers[p] = 4.0 * static_cast<double>(1 + p);
  mcs::DepositGrid grid;
  grid.y_bins = functionals.y_bins;
  grid.v_bins = functionals.v_bins;
  stream.sums.y_bins.assign(20, 0);
  stream.sums.v_bins.assign(20, 0);
  stream.sums.y_bins[mcs::DepositedSums::kBinOffset + 3] = 2;
  stream.sums.v_bins[mcs::DepositedSums::kBinOffset + 4] = 1;
  const auto means = functionals.stream_means(stream);
  EXPECT_EQ(means[0], 1);   // y
  EXPECT_EQ(means[1], 3);   // y^2
  EXPECT_EQ(means[2], 10);  // y^4
  EXPECT_EQ(means[3], 2);   // v
  EXPECT_EQ(means[4], 5);   // v^2
  EXPECT_EQ(means[5], 14);  // v^4
  EXPECT_EQ(means[6 + 3], 0.5);
  EXPECT_EQ(means[6 + 8 + 4], 0.25);
  EXPECT_NEAR(functions[2].y_factor(2) * functions[2].v_factor(7), 16, 1e-12);
  EXPECT_NEAR(functions[6 + 3].y_factor(0.4), 2.0 / 3, 1e-15);
  EXPECT_NEAR(functions[6 + 8 + 4].v_factor(1), 2.0 / 3, 1e-15);
}

}  // namespace
}  // namespace fpkcheck::control_variates
