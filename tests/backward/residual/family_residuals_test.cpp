#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "backward/residual/density_error_estimator.hpp"
#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::backward {
namespace {

using problem::SystemCoefficients;
using problem::WallParameters;

/// Problem under white noise whose exact density is known.
struct ExactCase {
  std::string name;
  SystemCoefficients system;
  WallParameters walls;
  double intensity;

  problem::Problem problem(double factor = 1) const {
    return tests::with_noise(problem::System(system, walls), factor * intensity);
  }
};

const SystemCoefficients kDuffing{.damping = 0.2, .stiffness = 1, .cubic = 0.5};

/// Systems with r = 1 and white noise, with the exact density exact::EnergyLaw.
const std::vector<ExactCase> kExactCases{
    {"no wall", kDuffing, {.none = true}, 0.4},
    {"gap", kDuffing, {.left = -0.5, .left_restitution = 1}, 0.4},
    {"preload", kDuffing, {.left = 0.5, .left_restitution = 1}, 0.4},
    {"two walls",
     kDuffing,
     {.left = -0.5, .left_restitution = 1, .right = 0.8, .right_restitution = 1},
     0.4},
    {"tilted double well",
     {.damping = 0.2, .constant = 0.1, .stiffness = -1, .cubic = 1},
     {.none = true},
     0.2},
    {"ring", {.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}, 0.4},
    {"ball", {.damping = 0.2, .constant = 1, .restitution = 1}, {}, 0.4},
    {"quintic",
     {.damping = 0.3, .stiffness = 1, .quadratic = 0.3, .quintic = 0.2},
     {.none = true},
     0.6}};

/// The exact density of a problem, in the coordinates of the problem.
transform::SmoothDensity exact_density(const problem::Problem& problem) {
  const auto law = std::make_shared<const exact::EnergyLaw>(problem);
  const auto scales = problem::motion_scales(problem);
  const double margin = 0.1 * (scales.y_high - scales.y_low);
  const auto &left = problem.system.left_wall(), &right = problem.system.right_wall();
  return {[law](double y, double v) { return (*law)(y, v); },
          right ? right->position : scales.y_high + margin, 1.1 * scales.v_high,
          left ? left->position : scales.y_low - margin};
}

/// Returns the L1 distance of two functions.
double l1_distance(const std::function<double(double)>& a, const std::function<double(double)>& b,
                   double from, double to) {
  return numerics::integrate_by_composite_gauss([&](double x) { return std::abs(a(x) - b(x)); },
                                                from, to, 40);
}

transform::Moments exact_moments(const problem::Problem& problem) {
  const exact::EnergyLaw law(problem);
  return {law.moment(1, 0), law.moment(2, 0), law.moment(4, 0),
          law.moment(0, 1), law.moment(0, 2), law.moment(0, 4)};
}

TEST(FamilyResiduals, FindNoErrorInExactLaws) {
  for (const auto& one : kExactCases) {
    const auto problem = tests::in_wall_coordinates(one.problem());
    const auto found = DensityErrorEstimator(problem, {.y_cells = 20, .v_cells = 40})
                           .estimate_errors(exact_density(problem));
    EXPECT_LT(found.y_l1.dual_weighted_error, 1e-7) << one.name;
    EXPECT_LT(found.ydot_l1.dual_weighted_error, 1e-7) << one.name;
    const auto known = exact_moments(one.problem());
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      EXPECT_NEAR(found.corrected_moments.*moment, known.*moment, 1e-7) << one.name << ' ' << name;
    }
  }
}

TEST(FamilyResiduals, EstimateTheErrorsOfALawWithStrongerNoise) {
  constexpr double kStronger = 1.05;
  for (const auto& one : kExactCases) {
    const auto problem = tests::in_wall_coordinates(one.problem());
    const auto right = exact_density(problem),
               wrong = exact_density(tests::in_wall_coordinates(one.problem(kStronger)));
    const auto found =
        DensityErrorEstimator(problem, {.y_cells = 28, .v_cells = 60}).estimate_errors(wrong);
    // Moments in physical coordinates.
    const auto known = exact_moments(one.problem()),
               of_wrong = exact_moments(one.problem(kStronger));
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      const double error = of_wrong.*moment - known.*moment;
      EXPECT_NEAR(found.corrected_moments.*moment, known.*moment, 1e-7 + 1e-5 * std::abs(error))
          << one.name << ' ' << name;
      EXPECT_NEAR(found.moment_errors.*moment, error, 1e-7 + 1e-5 * std::abs(error))
          << one.name << ' ' << name;
    }
    const exact::EnergyLaw a(problem), b(tests::in_wall_coordinates(one.problem(kStronger)));
    const double y =
        l1_distance([&](double x) { return a.displacement_marginal(x); },
                    [&](double x) { return b.displacement_marginal(x); }, wrong.y_min, wrong.y_max);
    const double v =
        l1_distance([&](double x) { return a.velocity_marginal(x); },
                    [&](double x) { return b.velocity_marginal(x); }, -wrong.v_max, wrong.v_max);
    EXPECT_GT(y, 2e-3) << one.name;
    EXPECT_NEAR(found.y_l1.dual_weighted_error / y, 0.95, 0.05) << one.name;
    EXPECT_NEAR(found.ydot_l1.dual_weighted_error / v, 0.95, 0.05) << one.name;
    const auto error_estimate = found.error_estimate();
    ASSERT_TRUE(error_estimate) << one.name;
    EXPECT_GT(error_estimate->y_l1, y) << one.name;
    EXPECT_LT(error_estimate->y_l1, 1.8 * y) << one.name;
    EXPECT_GT(error_estimate->ydot_l1, v) << one.name;
    EXPECT_LT(error_estimate->ydot_l1, 1.8 * v) << one.name;
  }
}

TEST(FamilyResiduals, DetectMassInTheWrongWell) {
  // The slowest mode: exchange of probability between two wells.
  const ExactCase tilted{
      "", {.damping = 0.2, .constant = 0.02, .stiffness = -1, .cubic = 1}, {.none = true}, 0.1};
  ExactCase other = tilted;
  other.system.constant = 0.03;
  const auto known = exact_moments(tilted.problem()), of_wrong = exact_moments(other.problem());
  const auto found = DensityErrorEstimator(tilted.problem(), {.y_cells = 28, .v_cells = 60})
                         .estimate_errors(exact_density(other.problem()));
  ASSERT_GT(std::abs(of_wrong.y1 - known.y1), 0.03);
  EXPECT_NEAR(found.moment_errors.y1, of_wrong.y1 - known.y1, 1e-5);
}

/// Two wells with a barrier of `height` times the mean energy per degree of freedom.
ExactCase deep_wells(double height) {
  constexpr double kDamping = 0.2, kDepth = 0.25;
  return {"",
          {.damping = kDamping, .constant = 0.02, .stiffness = -1, .cubic = 1},
          {.none = true},
          2 * kDamping * kDepth / height};
}

/// A density with other probabilities of the wells on both sides of a barrier: multiplied by
/// 1 + factor tanh((y - barrier)/0.1) and normalised.
transform::SmoothDensity with_other_well_probabilities(transform::SmoothDensity density,
                                                       const exact::EnergyLaw& law, double barrier,
                                                       double factor) {
  const auto one = [=](double y) { return 1 + factor * std::tanh((y - barrier) / 0.1); };
  const double mass = numerics::integrate_by_composite_gauss(
      [&](double y) { return one(y) * law.displacement_marginal(y); }, density.y_min, density.y_max,
      200);
  density.value = [=, value = density.value](double y, double v) {
    return one(y) * value(y, v) / mass;
  };
  return density;
}

TEST(FamilyResiduals, EstimateNoErrorForExactLawsOfDeepWells) {
  const auto wells = deep_wells(10);
  const auto error_estimate = DensityErrorEstimator(wells.problem())
                                  .estimate_errors(exact_density(wells.problem()))
                                  .error_estimate();
  ASSERT_TRUE(error_estimate);
  EXPECT_LT(error_estimate->y_l1, 1e-6);
  EXPECT_LT(error_estimate->ydot_l1, 1e-6);
}

TEST(FamilyResiduals, BoundTheErrorOfTheProbabilitiesOfWells) {
  const auto right_well_probability = [](const transform::SmoothDensity& p) {
    const auto mass = [&](double from) {
      return numerics::integrate_by_composite_gauss([&](double y) { return p.value(y, 0); }, from,
                                                    p.y_max, 200);
    };
    return mass(0) / mass(p.y_min);
  };
  // The exchange rate between the wells is of order exp(-height). The fit resolves this rate for a
  // height of 10, not for 25.
  for (const double height : {10.0, 25.0}) {
    const auto wells = deep_wells(height);
    const DensityErrorEstimator estimator(wells.problem());
    const auto right = exact_density(wells.problem());
    const double known = right_well_probability(right);
    for (const double factor : {-0.95, -0.3}) {
      const auto wrong =
          with_other_well_probabilities(right, exact::EnergyLaw(wells.problem()), 0, factor);
      const double moved = std::abs(right_well_probability(wrong) - known);
      ASSERT_GT(moved, 0.005) << height << ' ' << factor;
      const auto error_estimate = estimator.estimate_errors(wrong).error_estimate();
      const double error =
          error_estimate ? error_estimate->y_l1 : std::numeric_limits<double>::infinity();
      EXPECT_GT(error, 2 * moved) << height << ' ' << factor;
    }
  }
}

/// Asymmetric quartic and sextic potentials with several wells, some with a wall within a well. The
/// barriers are 1 to 12 mean energies per degree of freedom, and the damping is 0.02 to 2.
ExactCase random_wells(std::uint64_t number) {
  boost::random::mt19937_64 engine(number);
  boost::random::uniform_01<double> unit;
  const auto between = [&](double from, double to) { return from + (to - from) * unit(engine); };
  const double damping = 0.02 * std::pow(100, between(0, 1)), height = between(1, 12);
  ExactCase wells{"number " + std::to_string(number),
                  {.damping = damping, .constant = between(-0.06, 0.06), .stiffness = -1},
                  {.none = true},
                  0};
  const bool sixth = unit(engine) < 0.3;
  (sixth ? wells.system.quintic : wells.system.cubic) = 1;
  if (!sixth) wells.system.quadratic = between(-0.2, 0.2);
  if (unit(engine) < 0.3) wells.walls = {.left = between(-1.2, -0.7), .left_restitution = 1};
  wells.intensity = 2 * damping * (sixth ? 1.0 / 3 : 0.25) / height;
  return wells;
}

TEST(RandomWells, HaveReliableErrorEstimatesOrNone) {
  constexpr int kCount = 30;
  int known = 0, accurate = 0;
  for (int number = 1; number <= kCount; ++number) {
    const ExactCase wells = random_wells(static_cast<std::uint64_t>(number));
    const auto problem = tests::in_wall_coordinates(wells.problem());
    const DensityErrorEstimator estimator(problem);
    const auto right = exact_density(problem);
    const exact::EnergyLaw law(problem);
    const auto check = [&](const transform::SmoothDensity& density,
                           const std::function<double(double)>& marginal) {
      const auto error_estimate = estimator.estimate_errors(density).error_estimate();
      if (!error_estimate) return std::numeric_limits<double>::infinity();
      const double error = l1_distance([&](double y) { return law.displacement_marginal(y); },
                                       marginal, right.y_min, right.y_max);
      EXPECT_GT(error_estimate->y_l1, error - 0.004) << wells.name;
      return error_estimate->y_l1;
    };
    const double of_exact = check(right, [&](double y) { return law.displacement_marginal(y); });
    known += std::isfinite(of_exact) ? 1 : 0;
    accurate += of_exact < 0.02 ? 1 : 0;
    const exact::EnergyLaw hotter(tests::in_wall_coordinates(wells.problem(1.05)));
    check(exact_density(tests::in_wall_coordinates(wells.problem(1.05))),
          [&](double y) { return hotter.displacement_marginal(y); });
    const double barrier = problem.frame.wall_coordinate(0);
    for (const double factor : {-0.95, -0.3, 0.3, 0.95}) {
      const auto wrong = with_other_well_probabilities(right, law, barrier, factor);
      // In these laws the velocity is independent of y.
      const double v = 0.1, ratio = law.displacement_marginal(barrier) / law(barrier, v);
      check(wrong, [&](double y) { return wrong.value(y, v) * ratio; });
    }
  }
  EXPECT_GE(known, 20);
  EXPECT_GE(accurate, 15);
}

TEST(FamilyResiduals, AreThoseOfTheMirroredProblem) {
  const auto impulses = tests::gaussian_impulses(1.5, 0.1, 0.1);
  SystemCoefficients system{.damping = 0.1,
                            .van_der_pol = 0.1,
                            .rayleigh = 0.05,
                            .constant = 0.1,
                            .stiffness = 1,
                            .quadratic = 0.2,
                            .cubic = 0.4};
  const WallParameters walls{
      .left = -0.8, .left_restitution = 0.8, .right = 1.2, .right_restitution = 0.9},
      mirrored_walls{.left = -1.2, .left_restitution = 0.9, .right = 0.8, .right_restitution = 0.8};
  auto one = tests::with_impulses(problem::System(system, walls), impulses);
  system.constant = -system.constant;
  system.quadratic = -system.quadratic;
  auto other = tests::with_impulses(problem::System(system, mirrored_walls),
                                    impulses.with_negated_amplitudes());
  one.noise = other.noise = {.intensity = 0.05};
  const auto bell = [](double y, double v) {
    return std::exp(-std::pow(y - 0.1, 2) - 2 * v * v - v * y);
  };
  const ControlVariateCellCounts cells{.y_cells = 26, .v_cells = 52};
  const auto a = DensityErrorEstimator(tests::in_wall_coordinates(one), cells)
                     .estimate_errors(transform::SmoothDensity{
                         [&](double x, double v) { return bell(x - 0.8, v); }, 2, 3});
  const auto b = DensityErrorEstimator(tests::in_wall_coordinates(other), cells)
                     .estimate_errors(transform::SmoothDensity{
                         [&](double x, double v) { return bell(-(x - 1.2), -v); }, 2, 3});
  // The splines are graded equally from both walls.
  EXPECT_NEAR(a.y_l1.dual_weighted_error, b.y_l1.dual_weighted_error,
              1e-4 * a.y_l1.dual_weighted_error);
  EXPECT_NEAR(a.ydot_l1.dual_weighted_error, b.ydot_l1.dual_weighted_error,
              1e-4 * a.ydot_l1.dual_weighted_error);
  EXPECT_NEAR(a.corrected_moments.y1, -b.corrected_moments.y1, 1e-6);
  EXPECT_NEAR(a.corrected_moments.y2, b.corrected_moments.y2, 1e-6);
  EXPECT_NEAR(a.corrected_moments.y4, b.corrected_moments.y4, 1e-6);
  EXPECT_NEAR(a.moment_errors.y1, -b.moment_errors.y1, 1e-6);
  EXPECT_NEAR(a.moment_errors.v2, b.moment_errors.v2, 1e-6);
  EXPECT_NEAR(a.moment_errors.v1, -b.moment_errors.v1, 1e-6);
  EXPECT_GT(std::abs(a.moment_errors.v1), 1e-3);
  EXPECT_GT(std::abs(a.moment_errors.v2), 0.01);
}

TEST(FamilyResiduals, CorrectAnyDensityToTheExactCumulants) {
  auto problem = tests::with_impulses(
      problem::System({.damping = 0.2, .stiffness = 1}, {.none = true}),
      problem::ImpulseTrain({.arrival_rate = 1, .law = "laplace", .intensity = 0.1, .mean = 0.1}));
  problem.noise = {.intensity = 0.1};
  const auto bell = [](double y, double v) {
    return std::exp(-(y - 0.2) * (y - 0.2) - 0.8 * v * v) * (1 + 0.1 * std::tanh(y + v));
  };
  const auto found = DensityErrorEstimator(problem, {.y_cells = 28, .v_cells = 60})
                         .estimate_errors(transform::SmoothDensity{bell, 5, 5.5, -5});
  const auto kappa = [&](int p, int q) { return exact::linear_cumulant(problem, p, q); };
  const double y1 = kappa(1, 0), y2 = kappa(2, 0), y3 = kappa(3, 0);
  EXPECT_NEAR(found.corrected_moments.y1, y1, 1e-8);
  EXPECT_NEAR(found.corrected_moments.y2, y2 + y1 * y1, 1e-8);
  EXPECT_NEAR(found.corrected_moments.y4,
              kappa(4, 0) + 3 * y2 * y2 + 4 * y3 * y1 + 6 * y2 * y1 * y1 + std::pow(y1, 4), 1e-6);
  EXPECT_NEAR(found.corrected_moments.v2, kappa(0, 2), 1e-8);
  EXPECT_NEAR(found.corrected_moments.v4, kappa(0, 4) + 3 * kappa(0, 2) * kappa(0, 2), 1e-6);
  EXPECT_GT(std::abs(found.moment_errors.y2), 0.01);
}

TEST(FamilyResiduals, RejectRestAtomsAndAccumulatingImpacts) {
  const SystemCoefficients pressed{
      .damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.7};
  const auto impulses = tests::gaussian_impulses(1, 0.5);
  EXPECT_NE(residuals_unsupported_reason(tests::with_impulses(problem::System(pressed), impulses)),
            "");
  EXPECT_EQ(residuals_unsupported_reason(tests::with_noise(problem::System(pressed), 0.5)), "");
  const SystemCoefficients soft{.damping = 0.1, .stiffness = 1, .restitution = 0.15};
  EXPECT_NE(residuals_unsupported_reason(tests::with_noise(problem::System(soft), 0.5)), "");
  EXPECT_EQ(residuals_unsupported_reason(tests::with_impulses(problem::System(soft), impulses)),
            "");
}

}  // namespace
}  // namespace fpkcheck::backward
