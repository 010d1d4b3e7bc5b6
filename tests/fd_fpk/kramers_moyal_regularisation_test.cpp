#include "fd_fpk/kramers_moyal_regularisation.hpp"

#include <gtest/gtest.h>

#include "fd_fpk/operator/well_posedness.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

const KramersMoyalRegularisationResult& row_of(const KramersMoyalRegularisationStudy& study,
                                               const std::string& scheme, double division) {
  for (const auto& row : study.rows) {
    if (row.scheme == scheme && std::abs(row.step * division / study.default_length - 1) < 1e-9) {
      return row;
    }
  }
  throw std::out_of_range(scheme);
}

TEST(RegularisationStudy, LiteralSchemeGrowsOnFineStepsAndItsNullVectorIsNoDensity) {
  const auto p = tests::make_problem();
  int calls = 0;
  const auto study =
      study_kramers_moyal_regularisation(p, {.divisions = {1, 2, 4}}, [&](int row, int rows) {
        EXPECT_LT(row, rows);
        ++calls;
      });
  EXPECT_GE(calls, 15);
  ASSERT_EQ(study.rows.size(), 15u);
  EXPECT_NEAR(study.default_length, std::sqrt(0.1), 1e-12);

  // 16 D4/h^4 - 6.04 D2/h^2 < 0 at h = l: there the literal and the regularised scheme coincide.
  EXPECT_FALSE(row_of(study, "literal", 1).growth_rate(p));
  EXPECT_EQ(row_of(study, "literal", 1).l1_y, row_of(study, "regularised", 1).l1_y);
  EXPECT_NEAR(*row_of(study, "literal", 2).growth_rate(p), 16.5, 1.5);
  const auto& literal = row_of(study, "literal", 4);
  EXPECT_NEAR(literal.symbol->rate, 464, 1);
  EXPECT_NEAR(*literal.growth_rate(p) / literal.symbol->rate, 0.985, 0.01);
  EXPECT_GT(*literal.l1_ydot, 0.5);
  EXPECT_LT(*literal.min_density, -0.1);

  for (const double division : {1, 2, 4}) {
    const auto& row = row_of(study, "regularised", division);
    EXPECT_FALSE(row.growth_rate(p));
    EXPECT_LT(std::abs(*row.rightmost), 1e-10);
    EXPECT_NEAR(row.next->real(), -0.1186, 1e-3);
    EXPECT_LT(*row.l1_y, 5e-4);
    EXPECT_LT(*row.l1_ydot, 6e-4);
    EXPECT_GT(*row.min_density, -1e-5);
    EXPECT_EQ(row.remark, "");
    EXPECT_FALSE(row_of(study, "pade", division).growth_rate(p));
  }
  // Lengths on both sides of the threshold l*, with a velocity step that resolves l*.
  EXPECT_GT(row_of(study, "0.9 l*", 4).symbol->rate, 1);
  EXPECT_NEAR(row_of(study, "0.9 l*", 4).growth_rate(p).value_or(0), 1.5, 0.3);
  EXPECT_FALSE(row_of(study, "1.1 l*", 4).growth_rate(p));
}

TEST(RegularisationStudy, ReportsSchemesThatDoNotExistForALaw) {
  // A law with a small variance and a large mean: its skewness about zero is so large that the Pade
  // approximant has a pole.
  const auto skew = tests::make_problem({.mean = 0.29, .law = "two_point"});
  const auto study = study_kramers_moyal_regularisation(skew, {.divisions = {1}});
  const auto& pade = row_of(study, "pade", 1);
  EXPECT_NE(pade.remark.find("does not exist"), std::string::npos) << pade.remark;
  EXPECT_FALSE(pade.symbol || pade.rightmost || pade.l1_y);
  EXPECT_TRUE(row_of(study, "regularised", 1).l1_y);
}

TEST(RegularisationStudy, OmitsEigenvaluesOfLargeMatrices) {
  const auto frequent = tests::make_problem({.rate = 40});
  const auto study = study_kramers_moyal_regularisation(frequent, {.divisions = {2}, .nx = 16});
  for (const auto& row : study.rows) {
    EXPECT_FALSE(row.rightmost);
    EXPECT_NE(row.remark.find("no eigenvalue"), std::string::npos);
    EXPECT_TRUE(row.symbol);
  }
  EXPECT_TRUE(row_of(study, "literal", 2).growth_rate(frequent));
}

TEST(RegularisationStudy, PadeApproximantDecaysOnFineSteps) {
  // The kernel extends far outside a stencil: a truncated axis would show a spurious instability.
  const auto p = tests::make_problem();
  FiniteVolumeOptions pade;
  pade.equation = DensityEquation::km4_pade;
  for (const double step : {0.1, 0.04, 0.02}) {
    EXPECT_FALSE(is_growing_wave(fastest_growing_wave(p, pade, step), p.impulses)) << step;
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
