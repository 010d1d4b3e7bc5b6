#include "fd_fpk/excitation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fd_fpk/well_posedness.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

Eigen::MatrixXd matrix_of(const Line& line, const Excitation& excitation) {
  Eigen::MatrixXd matrix = local_excitation(line, excitation, 6);
  if (excitation.exchange.size() > 0) matrix += excitation.exchange;
  return matrix;
}

// d/dt of the moment E[v^power] of a unit mass in the middle cell of a long line, about that cell's
// centre: for jumps lambda E[Y^power], for derivatives their coefficients times factorials. The
// moments are those of cell averages, exact for what is exact on polynomials.
double moment_rate(const Line& line, const Excitation& excitation, int power) {
  const int source = line.cells() / 2;
  const Eigen::VectorXd rates = matrix_of(line, excitation).col(source);
  double rate = 0;
  for (int to = 0; to < line.cells(); ++to) {
    rate += rates(to) * std::pow(line.centre(to) - line.centre(source), power);
  }
  return rate;
}

const Line kLong = Line::uniform(-10.05, 0.1, 201);

TEST(Excitation, TruncatedSeriesHasTheFirstFourMoments) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const double l = 0.6;
  const Excitation e = kramers_moyal(p.impulses, kLong, l);
  EXPECT_NEAR(moment_rate(kLong, e, 0), 0.0, 1e-9);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_moment(j), 1e-8) << j;
  }
}

TEST(Excitation, TruncatedSeriesNeedsNoLengthThatFitsTheCells) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Excitation e = kramers_moyal(p.impulses, kLong, 0.567);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_moment(j), 1e-7) << j;
  }
}

TEST(Excitation, DefaultLengthReproducesTheSixthMomentToo) {
  const auto p = tests::make_problem();
  const double l = default_regularisation_length(p.impulses.law());
  EXPECT_NEAR(l, std::sqrt(0.1), 1e-14);  // a zero-mean gaussian: its deviation
  const Line line = Line::uniform(-100.5 * l / 3, l / 3, 201);
  EXPECT_NEAR(moment_rate(line, kramers_moyal(p.impulses, line, l), 6), p.impulses.rate_moment(6),
              1e-8);
}

TEST(Excitation, PadeApproximantHasTheFirstFourMomentsOfAnyLaw) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Excitation e = kramers_moyal_pade(p.impulses, kLong, 6);
  EXPECT_NEAR(moment_rate(kLong, e, 0), 0.0, 1e-9);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_moment(j), 1e-6) << j;
  }
}

TEST(Excitation, WhiteNoiseHasTheFirstTwoMomentsAndNoMore) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Excitation e = white_noise(p.impulses);
  EXPECT_NEAR(moment_rate(kLong, e, 1), p.impulses.rate_moment(1), 1e-10);
  EXPECT_NEAR(moment_rate(kLong, e, 2), p.impulses.rate_moment(2), 1e-10);
  EXPECT_NEAR(moment_rate(kLong, e, 4), 0.0, 1e-10);
}

TEST(Excitation, KeepsMassOnAShortLineWithWallsAndUnequalCells) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Line line({-1.0, -0.8, -0.55, -0.35, -0.2, -0.1, 0, 0.1, 0.22, 0.37, 0.5, 0.66, 0.8, 1.0});
  for (const Excitation& e : {white_noise(p.impulses), kramers_moyal(p.impulses, line, 0.4),
                              kramers_moyal_pade(p.impulses, line, 4), jumps(p.impulses, line)}) {
    const Eigen::RowVectorXd leak = line.widths().transpose() * matrix_of(line, e);
    EXPECT_LT(leak.cwiseAbs().maxCoeff(), 1e-10);
  }
}

// The largest growth of an excitation on a long line of this step.
template <class MakeExcitation>
Growth growth(double step, int cells, const MakeExcitation& make) {
  const Line line = Line::uniform(0, step, 2 * cells + 1);
  return largest_growth(line, make(line), 6);
}

TEST(WellPosedness, LiteralTruncationGrowsWithTheFourthPowerOfTheResolution) {
  const auto impulses = tests::make_problem().impulses;
  const double s = std::sqrt(0.1);
  const auto literal = [&](double step) {
    return growth(step, 20, [&](const Line& line) { return kramers_moyal(impulses, line, step); });
  };
  EXPECT_GT(literal(s / 2).rate, 0);
  EXPECT_NEAR(literal(s / 64).rate / literal(s / 32).rate, 16.0, 0.5);
  EXPECT_NEAR(literal(s / 8).wavenumber, std::numbers::pi / (s / 8), 1e-9);  // the grid's own
}

TEST(WellPosedness, RegularisedTruncationDecaysOnEveryGrid) {
  const auto impulses = tests::make_problem({.mean = 0.1}).impulses;
  const double l = default_regularisation_length(impulses.law());
  for (const double cells : {1.0, 1.4, 2.0, 5.3, 20.0}) {
    const auto g = growth(l / cells, static_cast<int>(2 * cells) + 20,
                          [&](const Line& line) { return kramers_moyal(impulses, line, l); });
    EXPECT_LT(g.rate, 0.0) << cells;
  }
}

TEST(WellPosedness, ShortestLengthIsTheThreshold) {
  const auto impulses = tests::make_problem().impulses;
  const double shortest = shortest_regularisation_length(impulses.law());
  EXPECT_NEAR(shortest, std::sqrt(2.1002465 * 0.25 * 0.1), 1e-6);  // D4/D2 = s^2/4
  const auto rate = [&](double l) {
    return growth(l / 40, 100, [&](const Line& line) { return kramers_moyal(impulses, line, l); })
        .rate;
  };
  EXPECT_GT(rate(0.99 * shortest), 0.0);
  EXPECT_LT(rate(1.01 * shortest), 0.0);
}

TEST(WellPosedness, JumpsPadeAndWhiteNoiseNeverGrow) {
  const auto impulses = tests::make_problem({.mean = 0.1}).impulses;
  EXPECT_LE(growth(0.1, 60, [&](const Line& line) { return jumps(impulses, line); }).rate, 1e-12);
  EXPECT_LT(
      growth(0.1, 60, [&](const Line& line) { return kramers_moyal_pade(impulses, line, 6); }).rate,
      0.0);
  EXPECT_LT(growth(0.05, 20, [&](const Line&) { return white_noise(impulses); }).rate, 0.0);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
