#include "results/run.hpp"

#include <gtest/gtest.h>

#include "compare/comparison_bins.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::results {
namespace {

using transform::StateVariable;

TEST(Curves, ComputeBinWidthsFromCentres) {
  // At a twentieth of the default rate the bins at 0 are divided.
  const auto axes = compare::comparison_bins(tests::make_problem({.rate = 0.05}));
  ASSERT_GT(axes.divisions, 0);
  for (const StateVariable variable : transform::kVariables) {
    const transform::Marginal marginal{compare::comparison_bin_edges(axes, variable), {}, {}, {}};
    DensityCurve curve{"", variable, {}, {}, {}, {}};
    for (std::size_t b = 0; b + 1 < marginal.edges.size(); ++b) {
      curve.abscissa.push_back(marginal.bin_centre(b));
    }
    const auto widths = bin_widths(curve);
    for (std::size_t b = 0; b < widths.size(); ++b) {
      EXPECT_NEAR(widths[b], marginal.bin_width(b), 1e-11 * marginal.bin_width(0));
    }
  }
}

}  // namespace
}  // namespace fpkcheck::results
