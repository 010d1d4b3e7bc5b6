#include "fd_fpk/axis/excitation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

Eigen::MatrixXd matrix_of(const Axis& axis, const Excitation& excitation) {
  Eigen::MatrixXd matrix = local_excitation(axis, excitation, 6);
  if (excitation.exchange.size() > 0) matrix += excitation.exchange;
  return matrix;
}

// The rate of change of the moment E[v^power], about the centre of the middle cell of a long axis,
// for a unit mass in this cell. For jumps the rate is lambda E[Y^power]; for derivatives the rate
// is their coefficient times a factorial. The moments of cell averages are exact for operators that
// are exact on polynomials.
double moment_rate(const Axis& axis, const Excitation& excitation, int power) {
  const int source = axis.cell_count() / 2;
  const Eigen::VectorXd rates = matrix_of(axis, excitation).col(source);
  double rate = 0;
  for (int to = 0; to < axis.cell_count(); ++to) {
    rate += rates(to) * std::pow(axis.cell_centre(to) - axis.cell_centre(source), power);
  }
  return rate;
}

const Axis kLong = Axis::with_uniform_cells(-10.05, 0.1, 201);

TEST(Excitation, TruncatedSeriesHasTheFirstFourMoments) {
  for (const auto& p :
       {tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15}),
        tests::make_problem({.rate = 2.0, .intensity = 0.5, .law = "exponential"})}) {
    const double l = 0.6;
    const Excitation e = kramers_moyal_excitation(p.impulses, kLong, l);
    EXPECT_NEAR(moment_rate(kLong, e, 0), 0.0, 1e-9);
    for (int j = 1; j <= 4; ++j) {
      EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_times_moment(j), 1e-8) << j;
    }
  }
}

TEST(Excitation, RegularisationLengthNeedNotBeAMultipleOfTheCellWidth) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Excitation e = kramers_moyal_excitation(p.impulses, kLong, 0.567);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_times_moment(j), 1e-7) << j;
  }
}

TEST(Excitation, DefaultLengthReproducesTheSixthMomentToo) {
  const auto p = tests::make_problem();
  const double l = default_regularisation_length(p.impulses.law());
  EXPECT_NEAR(l, std::sqrt(0.1), 1e-14);  // for a zero-mean gaussian: its standard deviation
  const Axis axis = Axis::with_uniform_cells(-100.5 * l / 3, l / 3, 201);
  EXPECT_NEAR(moment_rate(axis, kramers_moyal_excitation(p.impulses, axis, l), 6),
              p.impulses.rate_times_moment(6), 1e-8);
}

TEST(Excitation, PadeApproximantHasTheFirstFourMomentsOfAnyLaw) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Excitation e = kramers_moyal_pade_excitation(p.impulses, kLong, 6);
  EXPECT_NEAR(moment_rate(kLong, e, 0), 0.0, 1e-9);
  for (int j = 1; j <= 4; ++j) {
    EXPECT_NEAR(moment_rate(kLong, e, j), p.impulses.rate_times_moment(j), 1e-6) << j;
  }
}

TEST(Excitation, WhiteNoiseHasTheFirstTwoMomentsAndNoMore) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Excitation e = white_noise_excitation(p.impulses);
  EXPECT_NEAR(moment_rate(kLong, e, 1), p.impulses.rate_times_moment(1), 1e-10);
  EXPECT_NEAR(moment_rate(kLong, e, 2), p.impulses.rate_times_moment(2), 1e-10);
  EXPECT_NEAR(moment_rate(kLong, e, 4), 0.0, 1e-10);
}

TEST(Excitation, ConservesMassOnAShortAxisWithUnequalCells) {
  const auto p = tests::make_problem({.rate = 2.0, .intensity = 0.5, .mean = 0.15});
  const Axis axis({-1.0, -0.8, -0.55, -0.35, -0.2, -0.1, 0, 0.1, 0.22, 0.37, 0.5, 0.66, 0.8, 1.0});
  for (const Excitation& e :
       {white_noise_excitation(p.impulses), kramers_moyal_excitation(p.impulses, axis, 0.4),
        kramers_moyal_pade_excitation(p.impulses, axis, 4), jump_excitation(p.impulses, axis)}) {
    const Eigen::RowVectorXd leak = axis.cell_widths().transpose() * matrix_of(axis, e);
    EXPECT_LT(leak.cwiseAbs().maxCoeff(), 1e-10);
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
