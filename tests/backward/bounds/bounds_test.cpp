#include "backward/bounds/bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "backward/bounds/bounds_from_grid.hpp"
#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "exact/linear_density.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::backward {
namespace {

const StationaryFunctional kMeanSquareDisplacement = PowerMoment{StateVariable::y, 2};
const StationaryFunctional kMeanSquareVelocity = PowerMoment{StateVariable::ydot, 2};

std::vector<numerics::Enclosure> bounds_on_level(
    const problem::Problem& problem, int level,
    const std::vector<StationaryFunctional>& functionals) {
  const SplineGrid grid = spline_grid_sequence(
      bound_width_limiting_feature(functionals[0]))[static_cast<std::size_t>(level)];
  return compute_bounds_on_grid(problem, make_residual_weight(problem, 12), grid, functionals, 2);
}

TEST(Bounds, OfCase1ContainTheReferenceAndExcludeWrongModels) {
  const std::vector<numerics::Enclosure> b = bounds_on_level(
      problem::load_case("case1"), 2, {kMeanSquareDisplacement, kMeanSquareVelocity});
  EXPECT_TRUE(b[0].contains(0.3945181772));
  EXPECT_TRUE(b[1].contains(0.4415122125));
  EXPECT_LT(b[0].half_width(), 3e-6);
  EXPECT_LT(b[1].half_width(), 3e-6);
  // Wrong values of the moments: with white noise, with the impact condition to first order, with
  // km4-pade, and by finite volumes on 20 x 40 cells.
  for (const double fault : {0.39700, 0.39416, 0.394545, 0.394560}) {
    EXPECT_FALSE(b[0].contains(fault)) << fault;
  }
}

TEST(Bounds, ResolveDampingAndRateToOneTenThousandth) {
  const numerics::Enclosure reference =
      bounds_on_level(problem::load_case("case1"), 2, {kMeanSquareVelocity})[0];
  for (const char* wrong : {"system.damping=0.10001", "impulse.rate=1.0001"}) {
    // The variance of the amplitudes is fixed: lambda E[Y^2] changes with lambda.
    const std::vector<std::string> overrides =
        wrong[0] == 's' ? std::vector<std::string>{wrong}
                        : std::vector<std::string>{wrong, "impulse.intensity=0.10001"};
    const numerics::Enclosure other =
        bounds_on_level(problem::load_case("case1", overrides), 2, {kMeanSquareVelocity})[0];
    EXPECT_TRUE(other.upper < reference.lower || other.lower > reference.upper) << wrong;
  }
}

TEST(Bounds, ContainExactMomentsWithoutLossesForEveryLaw) {
  for (const char* law : {"gaussian", "laplace", "two_point", "uniform"}) {
    const problem::Problem linear = problem::load_case(
        "case1", {"system.restitution=1", "system.cubic=0", std::string("impulse.law=") + law});
    const std::vector<numerics::Enclosure> b =
        bounds_on_level(linear, 0, {kMeanSquareDisplacement, kMeanSquareVelocity});
    EXPECT_TRUE(b[0].contains(exact::linear_cumulant(linear, 2, 0))) << law;
    EXPECT_TRUE(b[1].contains(exact::mean_square_velocity(linear))) << law;
    EXPECT_LT(b[0].half_width(), 1e-2 * b[0].midpoint()) << law;
    const problem::Problem cubic =
        problem::load_case("case1", {"system.restitution=1", std::string("impulse.law=") + law});
    const numerics::Enclosure v2 = bounds_on_level(cubic, 0, {kMeanSquareVelocity})[0];
    EXPECT_TRUE(v2.contains(exact::mean_square_velocity(cubic))) << law;
    EXPECT_LT(v2.half_width(), 1e-2 * v2.midpoint()) << law;
  }
}

TEST(Bounds, OfDifferentGridsOverlap) {
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{"system.restitution=0.5"},
        {"impulse.rate=0.3"},
        {"impulse.mean=0.0948683"},
        {"impulse.mean=-0.0948683", "impulse.law=laplace"},
        {"impulse.law=two_point"},
        {"system.cubic=1", "impulse.intensity=1"}}) {
    const problem::Problem problem = problem::load_case("case1", overrides);
    const std::vector<StationaryFunctional> all = default_functionals();
    const std::vector<numerics::Enclosure> coarse = bounds_on_level(problem, 0, all),
                                           fine = bounds_on_level(problem, 1, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_LE(coarse[i].lower, fine[i].upper) << overrides[0] << " " << functional_name(all[i]);
      EXPECT_LE(fine[i].lower, coarse[i].upper) << overrides[0] << " " << functional_name(all[i]);
    }
  }
}

TEST(Bounds, OfSmoothBinsContainTheExactDensity) {
  const problem::Problem linear =
      problem::load_case("case1", {"system.restitution=1", "system.cubic=0"});
  const exact::LinearDensity density(linear);
  const std::vector<StationaryFunctional> bins{
      SmoothBin::with_equidistant_knots(StateVariable::y, 0.9, 0.4),
      SmoothBin::with_equidistant_knots(StateVariable::ydot, -0.3, 0.4)};
  const std::vector<numerics::Enclosure> b = bounds_on_level(linear, 1, bins);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const std::vector<double> knots = integrand_breakpoints(bins[i]);
    constexpr int kCells = 400;
    std::vector<double> edges(kCells + 1);
    const double width = (knots.back() - knots.front()) / kCells;
    for (int n = 0; n <= kCells; ++n) edges[n] = knots.front() + n * width;
    const std::vector<double> p =
        i == 0 ? density.displacement_averages(edges) : density.velocity_averages(edges);
    double mean = 0;
    for (int n = 0; n < kCells; ++n) {
      const double x = edges[n] + width / 2;
      mean += p[n] * width * evaluate_integrand(bins[i], linear, x, x);
    }
    mean *= 4 / (knots.back() - knots.front());
    EXPECT_TRUE(b[i].contains(mean)) << b[i].lower << " " << mean << " " << b[i].upper;
    EXPECT_LT(b[i].half_width(), 0.1 * mean);
  }
}

TEST(Bounds, DoNotDependOnTheNumberOfThreads) {
  const problem::Problem problem = problem::load_case("case1");
  const std::vector<StationaryFunctional> both{kMeanSquareDisplacement, kMeanSquareVelocity};
  const ResidualWeightFunctionOfEnergy weight = make_residual_weight(problem, 12);
  const auto one = compute_bounds_on_grid(
      problem, weight, spline_grid_sequence(BoundWidthLimitingFeature::conical_point)[0], both, 1);
  const auto two = compute_bounds_on_grid(
      problem, weight, spline_grid_sequence(BoundWidthLimitingFeature::conical_point)[0], both, 2);
  for (std::size_t i = 0; i < both.size(); ++i) {
    EXPECT_EQ(one[i].lower, two[i].lower);
    EXPECT_EQ(one[i].upper, two[i].upper);
  }
}

TEST(Bounds, AreRefinedToTheRequestedWidth) {
  BoundsOptions options;
  options.functionals = {kMeanSquareDisplacement};
  options.absolute_half_width = 1e-5;
  const GuaranteedBounds narrow = compute_guaranteed_bounds(problem::load_case("case1"), options);
  EXPECT_EQ(narrow.status, BoundsStatus::ok);
  EXPECT_LE(narrow.functional_bounds[0].enclosure.half_width(), 1e-5);
  EXPECT_GT(narrow.grid_bounds.size(), 1u);
  EXPECT_LT(narrow.grid_bounds.size(),
            spline_grid_sequence(BoundWidthLimitingFeature::conical_point).size());

  options.absolute_half_width = 1e-12;
  options.time_limit_seconds = 0;
  const GuaranteedBounds wide = compute_guaranteed_bounds(problem::load_case("case1"), options);
  EXPECT_EQ(wide.status, BoundsStatus::width_not_met);
  EXPECT_EQ(wide.grid_bounds.size(), 1u);
  EXPECT_NE(wide.reason.find("--seconds"), std::string::npos) << wide.reason;
}

// After the common grids each functional continues with the grids of its width limit.
TEST(FinestBounds, AreAccurateToOneMillionth) {
  BoundsOptions options;
  options.relative_half_width = 1e-6;
  options.time_limit_seconds = 1e9;
  const GuaranteedBounds all = compute_guaranteed_bounds(problem::load_case("case1"), options);
  for (const FunctionalBounds& bound : all.functional_bounds) {
    const auto* const power = std::get_if<PowerMoment>(&bound.functional);
    const bool hardest =
        power != nullptr && power->variable == StateVariable::ydot && power->power == 4;
    EXPECT_LT(bound.enclosure.half_width() / bound.enclosure.midpoint(), hardest ? 6e-6 : 1e-6)
        << functional_name(bound.functional);
  }
  EXPECT_EQ(all.status, BoundsStatus::width_not_met);
  EXPECT_NE(all.reason.find("grid exists for E[y'^4]; request --width"), std::string::npos)
      << all.reason;
}

TEST(Bounds, RejectOverdampedMotionAndInvalidOptions) {
  const GuaranteedBounds refused =
      compute_guaranteed_bounds(problem::load_case("case1", {"system.damping=2.5"}));
  EXPECT_EQ(refused.status, BoundsStatus::not_offered);
  EXPECT_NE(refused.reason.find("c^2 >= 4k"), std::string::npos);
  EXPECT_TRUE(refused.functional_bounds.empty());
  BoundsOptions options;
  options.absolute_half_width = -1;
  EXPECT_THROW(compute_guaranteed_bounds(problem::load_case("case1"), options), InputError);
}

}  // namespace
}  // namespace fpkcheck::backward
