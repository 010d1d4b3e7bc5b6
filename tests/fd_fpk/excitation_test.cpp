#include "fd_fpk/excitation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fd_fpk/well_posedness.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// d/dt of the moment E[v^power] of a unit mass in one cell of a long line, about that cell's
// centre: for jumps lambda E[Y^power], for derivatives their coefficients times factorials.
double moment_rate(const Excitation& excitation, double step, int power) {
  const UniformLine line{0.0, step, 401};
  const int source = 200;
  const LineOperator op = excitation_operator(line, excitation, 6);
  double rate = 0;
  for (int to = 0; to < line.cells; ++to) {
    rate += op.coeff(to, source) * std::pow((to - source) * step, power);
  }
  return rate;
}

TEST(Excitation, JumpsHaveTheMomentsOfTheImpulseLaw) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const auto& impulses = p.impulses;
  const double spacing = largest_jump_spacing(p);
  for (const int cells : {1, 3}) {
    const Excitation e = jumps(impulses, spacing / cells, cells);
    EXPECT_NEAR(moment_rate(e, spacing / cells, 0), 0.0, 1e-12);
    for (int j = 1; j <= 6; ++j) {
      const double exact = impulses.rate_moment(j);
      EXPECT_NEAR(moment_rate(e, spacing / cells, j), exact, 2e-5 * std::abs(exact)) << j;
    }
  }
}

TEST(Excitation, TruncatedSeriesHasTheFirstFourMoments) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const double l = default_regularisation_length(p.impulses.law());
  const Excitation e = kramers_moyal(p.impulses, l / 2, 2);
  EXPECT_NEAR(moment_rate(e, l / 2, 0), 0.0, 1e-9);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(e, l / 2, j), p.impulses.rate_moment(j), 1e-8) << j;
  }
}

TEST(Excitation, DefaultLengthReproducesTheSixthMomentToo) {
  const auto p = tests::make_problem();
  const double l = default_regularisation_length(p.impulses.law());
  EXPECT_NEAR(l, std::sqrt(0.1), 1e-14);  // a zero-mean gaussian: its deviation
  const Excitation e = kramers_moyal(p.impulses, l / 3, 3);
  EXPECT_NEAR(moment_rate(e, l / 3, 6), p.impulses.rate_moment(6), 1e-8);
}

TEST(Excitation, WhiteNoiseHasTheFirstTwoMomentsAndNoMore) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Excitation e = white_noise(p.impulses);
  EXPECT_NEAR(moment_rate(e, 0.1, 1), p.impulses.rate_moment(1), 1e-11);
  EXPECT_NEAR(moment_rate(e, 0.1, 2), p.impulses.rate_moment(2), 1e-11);
  EXPECT_NEAR(moment_rate(e, 0.1, 4), 0.0, 1e-11);
}

TEST(Excitation, KeepsMassOnAShortLineWithWalls) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const UniformLine line{-1.0, 0.1, 20};
  for (const Excitation& e :
       {white_noise(p.impulses), kramers_moyal(p.impulses, 0.1, 4), jumps(p.impulses, 0.1, 2)}) {
    const Eigen::MatrixXd op = excitation_operator(line, e, 4);
    EXPECT_LT(op.colwise().sum().cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(WellPosedness, LiteralTruncationGrowsWithTheFourthPowerOfTheResolution) {
  const auto impulses = tests::make_problem().impulses;
  const double s = std::sqrt(0.1);
  const auto growth = [&](double step) {
    return largest_growth(kramers_moyal(impulses, step, 1), step, 6);
  };
  EXPECT_GT(growth(s / 2).rate, 0);
  EXPECT_NEAR(growth(s / 64).rate / growth(s / 32).rate, 16.0, 0.5);
  EXPECT_NEAR(growth(s / 8).wavenumber, std::numbers::pi / (s / 8), 1e-9);  // the grid's own
}

TEST(WellPosedness, RegularisedTruncationDecaysOnEveryGrid) {
  const auto impulses = tests::make_problem({.mean = 0.1}).impulses;
  const double l = default_regularisation_length(impulses.law());
  for (const int cells : {1, 2, 5, 20}) {
    EXPECT_LT(largest_growth(kramers_moyal(impulses, l / cells, cells), l / cells, 6).rate, 0.0);
  }
}

TEST(WellPosedness, ShortestLengthIsTheThreshold) {
  const auto impulses = tests::make_problem().impulses;
  const double shortest = shortest_regularisation_length(impulses.law());
  EXPECT_NEAR(shortest, std::sqrt(2.1002465 * 0.25 * 0.1), 1e-6);  // D4/D2 = s^2/4
  const auto rate = [&](double l) {
    return largest_growth(kramers_moyal(impulses, l / 40, 40), l / 40, 6).rate;
  };
  EXPECT_GT(rate(0.99 * shortest), 0.0);
  EXPECT_LT(rate(1.01 * shortest), 0.0);
}

TEST(WellPosedness, JumpsAndWhiteNoiseNeverGrow) {
  const auto p = tests::make_problem({.mean = 0.1});
  EXPECT_LE(largest_growth(jumps(p.impulses, 0.05, 3), 0.05, 6).rate, 1e-12);
  EXPECT_LT(largest_growth(white_noise(p.impulses), 0.05, 6).rate, 0.0);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
