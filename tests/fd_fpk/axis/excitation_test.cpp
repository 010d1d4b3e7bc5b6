#include "fd_fpk/axis/excitation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "laws.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

Eigen::MatrixXd matrix_of(const GridAxis& axis, const DiscretisedExcitation& excitation) {
  Eigen::MatrixXd matrix = drift_diffusion_matrix(axis, excitation, 6);
  if (excitation.exchange.size() > 0) matrix += excitation.exchange;
  return matrix;
}

// The rate of change of the moment E[v^power], about the centre of the middle cell of a long axis,
// for a unit mass in this cell. For jumps the rate is lambda E[Y^power]; for derivatives the rate
// is their coefficient times a factorial. The moments of cell averages are exact for operators that
// are exact on polynomials.
double moment_rate(const GridAxis& axis, const DiscretisedExcitation& excitation, int power) {
  const int source = axis.cell_count() / 2;
  const Eigen::VectorXd rates = matrix_of(axis, excitation).col(source);
  double rate = 0;
  for (int to = 0; to < axis.cell_count(); ++to) {
    rate += rates(to) * std::pow(axis.cell_centre(to) - axis.cell_centre(source), power);
  }
  return rate;
}

const GridAxis kLong = GridAxis::with_uniform_cells(-10.05, 0.1, 201);

TEST(Excitation, TruncatedSeriesHasTheFirstFourMoments) {
  for (const auto& p :
       {tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15}),
        tests::make_problem({.rate = 2.0, .intensity = 0.5, .law = "exponential"})}) {
    const double l = 0.6;
    const DiscretisedExcitation e = kramers_moyal_excitation(p.impulses, kLong, l);
    EXPECT_NEAR(moment_rate(kLong, e, 0), 0.0, 1e-9);
    for (int j = 1; j <= 4; ++j) {
      EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_times_moment(j), 1e-8) << j;
    }
  }
}

TEST(Excitation, RegularisationLengthNeedNotBeAMultipleOfTheCellWidth) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const DiscretisedExcitation e = kramers_moyal_excitation(p.impulses, kLong, 0.567);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_times_moment(j), 1e-7) << j;
  }
}

TEST(Excitation, DefaultLengthReproducesTheSixthMomentToo) {
  const auto p = tests::make_problem();
  const double l = default_regularisation_length(p.impulses.amplitude_law());
  EXPECT_NEAR(l, std::sqrt(0.1), 1e-14);  // for a zero-mean gaussian: its standard deviation
  const GridAxis axis = GridAxis::with_uniform_cells(-100.5 * l / 3, l / 3, 201);
  EXPECT_NEAR(moment_rate(axis, kramers_moyal_excitation(p.impulses, axis, l), 6),
              p.impulses.rate_times_moment(6), 1e-8);
}

TEST(Excitation, PadeApproximantHasTheFirstFourMomentsOfAnyLaw) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const DiscretisedExcitation e = kramers_moyal_pade_excitation(p.impulses, kLong, 6);
  EXPECT_NEAR(moment_rate(kLong, e, 0), 0.0, 1e-9);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_times_moment(j), 1e-6) << j;
  }
}

TEST(Excitation, WhiteNoiseHasTheFirstTwoMomentsAndNoMore) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const DiscretisedExcitation e = white_noise_excitation(p.impulses);
  EXPECT_NEAR(moment_rate(kLong, e, 1), p.impulses.rate_times_moment(1), 1e-10);
  EXPECT_NEAR(moment_rate(kLong, e, 2), p.impulses.rate_times_moment(2), 1e-10);
  EXPECT_NEAR(moment_rate(kLong, e, 4), 0.0, 1e-10);
}

TEST(Excitation, ConservesMassOnAShortAxisWithUnequalCells) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const GridAxis axis(
      {-1.0, -0.8, -0.55, -0.35, -0.2, -0.1, 0, 0.1, 0.22, 0.37, 0.5, 0.66, 0.8, 1.0});
  for (const DiscretisedExcitation& e :
       {white_noise_excitation(p.impulses), kramers_moyal_excitation(p.impulses, axis, 0.4),
        kramers_moyal_pade_excitation(p.impulses, axis, 4), jump_excitation(p.impulses, axis)}) {
    const Eigen::RowVectorXd leak = axis.cell_widths().transpose() * matrix_of(axis, e);
    EXPECT_LT(leak.cwiseAbs().maxCoeff(), 1e-10);
  }
}

// The largest growth rate of an excitation on a long axis with this step.
template <class MakeExcitation>
FastestGrowingWave growth(double step, int cells, const MakeExcitation& make) {
  const GridAxis axis = GridAxis::with_uniform_cells(0, step, 2 * cells + 1);
  return fastest_growing_wave(axis, make(axis), 6);
}

TEST(GrowthRate, LiteralTruncationGrowsWithTheFourthPowerOfTheResolution) {
  const auto impulses = tests::make_problem().impulses;
  const double s = std::sqrt(0.1);
  const auto literal = [&](double step) {
    return growth(step, 20, [&](const GridAxis& axis) {
      return kramers_moyal_excitation(impulses, axis, step);
    });
  };
  EXPECT_GT(literal(s / 2).rate, 0);
  EXPECT_NEAR(literal(s / 64).rate / literal(s / 32).rate, 16.0, 0.5);
  // The shortest wave of the grid.
  EXPECT_NEAR(literal(s / 8).wavenumber, std::numbers::pi / (s / 8), 1e-9);
}

TEST(GrowthRate, RegularisedTruncationDecaysOnEveryGrid) {
  const auto impulses = tests::make_problem({.mean = 0.1}).impulses;
  const double l = default_regularisation_length(impulses.amplitude_law());
  for (const double cells : {1.0, 1.4, 2.0, 5.3, 20.0}) {
    const auto g = growth(l / cells, static_cast<int>(2 * cells) + 20, [&](const GridAxis& axis) {
      return kramers_moyal_excitation(impulses, axis, l);
    });
    EXPECT_LT(g.rate, 0.0) << cells;
  }
}

TEST(GrowthRate, ShortestLengthIsTheThreshold) {
  const auto impulses = tests::make_problem().impulses;
  const double shortest = shortest_stable_regularisation_length(impulses.amplitude_law());
  EXPECT_NEAR(shortest, std::sqrt(2.1002465 * 0.25 * 0.1), 1e-6);  // D4/D2 = s^2/4
  const auto rate = [&](double l) {
    return growth(l / 40, 100,
                  [&](const GridAxis& axis) { return kramers_moyal_excitation(impulses, axis, l); })
        .rate;
  };
  EXPECT_GT(rate(0.99 * shortest), 0.0);
  EXPECT_LT(rate(1.01 * shortest), 0.0);
}

// On cells as wide as the length the fourth difference is unstable, first for flat laws: 5/12 is
// the largest D4 / (D2 l^2).
TEST(GrowthRate, DefaultLengthIsLongEnoughOnCellsOfAnyWidthForEveryLawAndOrder) {
  bool longer = false;
  for (const std::string law : {"two_point", "uniform", "gaussian"}) {
    const auto impulses = tests::make_problem({.mean = 0.01, .law = law}).impulses;
    const double of_law = default_regularisation_length(impulses.amplitude_law());
    for (const int points : {2, 6}) {
      for (const double width : {0.5, 1.05, 1.3, 6.0, 30.0}) {  // in units of the length
        const GridAxis axis = GridAxis::with_uniform_cells(0, width * of_law, 81);
        const double length = default_regularisation_length(impulses, axis, points);
        const auto g =
            fastest_growing_wave(axis, kramers_moyal_excitation(impulses, axis, length), points);
        EXPECT_FALSE(is_growing_wave(g, impulses)) << law << points << ' ' << width;
        EXPECT_GE(length, of_law);
        EXPECT_LT(length, 2.3 * of_law) << law << points << ' ' << width;
        longer |= length > of_law;
        EXPECT_TRUE(width > 0.5 || length == of_law) << law << points;
      }
    }
  }
  EXPECT_TRUE(longer);
}

TEST(GrowthRate, DefaultLengthFollowsTheWidestCellsOfAGradedAxis) {
  const auto impulses = tests::make_problem({.law = "two_point"}).impulses;
  const double l = default_regularisation_length(impulses.amplitude_law());
  const GridAxis narrow = GridAxis::with_uniform_cells(0, l / 4, 40);
  std::vector<double> faces = narrow.faces();
  for (int k = 0; k < 10; ++k) faces.push_back(faces.back() + 1.2 * l);
  EXPECT_EQ(default_regularisation_length(impulses, narrow, 6), l);
  EXPECT_EQ(
      default_regularisation_length(impulses, GridAxis(faces), 6),
      default_regularisation_length(impulses, GridAxis::with_uniform_cells(0, 1.2 * l, 10), 6));
}

TEST(GrowthRate, CriticalWidthsOmitSimilarAndNarrowCells) {
  const auto law = tests::make_problem().impulses.amplitude_law();
  const double l = default_regularisation_length(law);
  const GridAxis axis({0, l, 1.4 * l, 2.41 * l, 4.4 * l, 5.42 * l});
  EXPECT_EQ(possibly_unstable_cell_widths(axis, law, l).size(), 2u);
  const auto all = possibly_unstable_cell_widths(axis, law, 0.9 * l);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_DOUBLE_EQ(all[0], 1.4 * l - l);
}

TEST(GrowthRate, JumpsPadeAndWhiteNoiseNeverGrow) {
  const auto impulses = tests::make_problem({.mean = 0.1}).impulses;
  EXPECT_LE(
      growth(0.1, 60, [&](const GridAxis& axis) { return jump_excitation(impulses, axis); }).rate,
      1e-12);
  EXPECT_LT(
      growth(0.1, 60,
             [&](const GridAxis& axis) { return kramers_moyal_pade_excitation(impulses, axis, 6); })
          .rate,
      0.0);
  EXPECT_LT(
      growth(0.05, 20, [&](const GridAxis&) { return white_noise_excitation(impulses); }).rate,
      0.0);
}

// For any law and length, also at the transition to the moment formulas.
TEST(GrowthRate, JumpsOfAnyLengthNeverGrow) {
  for (const auto& name : tests::law_names_without_table()) {
    for (const double skewness : {0.0, 0.3, 2.0}) {
      if (skewness > 0 && name != "gamma") continue;
      problem::ImpulseParameters parameters{
          .arrival_rate = 1, .law = name, .intensity = 1, .mean = 0};
      if (skewness > 0) parameters.skewness = skewness;
      const problem::ImpulseTrain impulses(parameters);
      const double length = std::pow(impulses.amplitude_law().moment(8), 1.0 / 8);
      for (const double cells : {0.999, 0.5, 0.1, 1e-3}) {
        const double width = length / cells;
        const FastestGrowingWave found = fastest_growing_wave(
            GridAxis::with_uniform_cells(-20 * width, width, 41),
            jump_excitation(impulses, GridAxis::with_uniform_cells(-20 * width, width, 41)), 6);
        EXPECT_LE(found.rate, 1e-9) << name << " " << skewness << " " << cells;
      }
    }
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
