#include "workflows/check/chance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::check {
namespace {

using transform::Solution;
using transform::Variable;

Solution simulation() {
  Solution one;
  one.moments = {.y2 = 1};
  one.mass = 1;
  one.standard_errors = {.moments = {.y2 = 0.1}};
  one.sampling = {.y = 0.01, .ydot = 0.02, .y_99 = 0.03, .ydot_99 = 0.03};
  return one;
}

TEST(Chance, TheSameSeedIsTheSameToTheLastDigit) {
  Solution other = simulation();
  EXPECT_FALSE(moved_by_chance(simulation(), other));
  other.moments.v4 = 1e-300;
  EXPECT_TRUE(moved_by_chance(simulation(), other));
  other = simulation();
  other.standard_errors->moments.y2 = std::nextafter(0.1, 1);
  EXPECT_TRUE(moved_by_chance(simulation(), other));
  EXPECT_FALSE(moved_by_chance(Solution{}, other));
}

TEST(Chance, AnL1MovesByTheSamplingThatIsStated) {
  const Solution one = simulation();
  Claim claim{.kind = FigureKind::distance, .allowed = 1e-8};
  move_by_sampling(claim, std::nullopt, Variable::y, {});
  Solution silent = one;
  silent.sampling->y_99.reset();
  move_by_sampling(claim, silent.sampling, Variable::y, {});
  silent.sampling.reset();
  move_by_sampling(claim, silent.sampling, Variable::y, {});
  EXPECT_EQ(claim.kind, FigureKind::distance);
  EXPECT_EQ(claim.allowed, 1e-8);
  move_by_sampling(claim, one.sampling, Variable::ydot, {});
  EXPECT_EQ(claim.kind, FigureKind::simulated_l1);
  EXPECT_EQ(claim.allowed, 4);
  EXPECT_EQ(claim.error, 0.02);
  EXPECT_EQ(claim.in_99, 0.03);
}

TEST(Chance, MassIsAShareOfTheSamples) {
  // The L1 error of a histogram of n samples is at least sqrt(2/(pi n)); one sample has mass 1/n.
  Solution one = simulation();
  const double n = 1e4;
  one.sampling->y = std::sqrt(2 / (3.14159265358979 * n));
  EXPECT_NEAR(error_of_mass(one), 1 / n, 1e-10);
  one.mass = 0.99;
  EXPECT_NEAR(error_of_mass(one), std::sqrt(0.01 / n), 1e-5);
  one.sampling.reset();
  EXPECT_TRUE(std::isnan(error_of_mass(one)));
}

TEST(Chance, ErrorsOfFewStreamsScatterMore) {
  Solution few = simulation(), many = simulation();
  few.observations = transform::Observer().result(kStreams, std::int64_t{16}).take();
  many.observations = transform::Observer().result(kStreams, std::int64_t{1024}).take();
  const Tolerances tolerances;
  const double of_few = allowed_scatter(few, 1, 1, tolerances);
  const double of_many = allowed_scatter(many, 1, 1, tolerances);
  const double of_usual = allowed_scatter(simulation(), 1, 1, tolerances);
  EXPECT_NEAR(of_few, std::exp(1.25 * 4 / std::sqrt(15.0)) - 1, 1e-9);
  EXPECT_GT(of_few, of_usual);
  EXPECT_GT(of_usual, of_many);
  EXPECT_GT(allowed_scatter(many, 1, 2, tolerances), of_many);
  EXPECT_GT(allowed_scatter(many, 60, 1, tolerances), of_many);
}

}  // namespace
}  // namespace fpkcheck::check
