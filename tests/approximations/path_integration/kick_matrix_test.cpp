#include "approximations/path_integration/kick_matrix.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "general_oscillators.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::path_integration {
namespace {

using problem::DensityEquation;

const problem::System kSystem({.damping = 0.1, .stiffness = 1}, {.none = true});

SplineInterpolation interpolation() { return SplineInterpolation(tests::uniform_edges(-9, 9, 90)); }

double normal_density(double v, double mean, double variance) {
  return std::exp(-(v - mean) * (v - mean) / (2 * variance)) /
         std::sqrt(2 * std::numbers::pi * variance);
}

Eigen::VectorXd standard_normal_values(const SplineInterpolation& splines) {
  Eigen::VectorXd values(splines.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values(i) = normal_density(splines.points()[static_cast<std::size_t>(i)], 0, 1);
  return values;
}

TEST(SplineInterpolation, IntegratesAPolynomialOfDegreeFive) {
  const SplineInterpolation splines({-1, -0.2, 0.1, 1.5, 2});
  Eigen::VectorXd values(splines.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values(i) = std::pow(splines.points()[static_cast<std::size_t>(i)], 5);
  EXPECT_NEAR(splines.integrals().dot(splines.coefficients_from_values() * values),
              (64.0 - 1.0) / 6, 1e-12);
}

// Noise of the intensity 2D, with impulses as noise of the same mean and intensity.
TEST(KickMatrix, AddsTheVarianceOfNoise) {
  auto problem = tests::with_impulses(kSystem, tests::gaussian_impulses(2, 0.5, 0.3));
  problem.noise.intensity = 0.4;
  constexpr double kTime = 0.3;
  const auto splines = interpolation();
  const Eigen::VectorXd values = kick_matrix(problem, DensityEquation::white, 0, kTime, splines) *
                                 standard_normal_values(splines);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double v = splines.points()[static_cast<std::size_t>(i)];
    EXPECT_NEAR(values(i), normal_density(v, 0.6 * kTime, 1 + 0.9 * kTime), 1e-7) << v;
  }
}

// The number of impulses has the Poisson law with the mean lambda T.
TEST(KickMatrix, HasThePoissonLawOfImpulses) {
  constexpr double kRate = 2, kMean = 0.3, kTime = 0.7, kIntensity = 0.5;
  constexpr double kVariance = kIntensity / kRate - kMean * kMean;
  const auto problem =
      tests::with_impulses(kSystem, tests::gaussian_impulses(kRate, kIntensity, kMean));
  const auto splines = interpolation();
  const Eigen::VectorXd values = kick_matrix(problem, DensityEquation::kf, 0, kTime, splines) *
                                 standard_normal_values(splines);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double v = splines.points()[static_cast<std::size_t>(i)];
    double exact = 0, weight = std::exp(-kRate * kTime);
    for (int n = 0; n < 40; weight *= kRate * kTime / ++n)
      exact += weight * normal_density(v, n * kMean, 1 + n * kVariance);
    EXPECT_NEAR(values(i), exact, 1e-7) << v;
  }
}

// The moments after the time T are those of the initial density and of the compound Poisson law.
TEST(KickMatrix, HasTheCumulantsOfAmplitudesWithAtomsAndSkewness) {
  for (const char* law : {"two_point", "exponential", "laplace"}) {
    const problem::ImpulseTrain impulses(
        {.arrival_rate = 1, .law = law, .intensity = 0.3, .mean = 0.2});
    auto problem = tests::with_impulses(kSystem, impulses);
    constexpr double kTime = 0.4;
    const auto splines = interpolation();
    const Eigen::VectorXd values = kick_matrix(problem, DensityEquation::kf, 0, kTime, splines) *
                                   standard_normal_values(splines);
    const auto moment = [&](int order) {
      Eigen::VectorXd integrand = values;
      for (Eigen::Index i = 0; i < values.size(); ++i)
        integrand(i) *= std::pow(splines.points()[static_cast<std::size_t>(i)], order);
      return splines.integrals().dot(splines.coefficients_from_values() * integrand);
    };
    const double mean = moment(1), variance = moment(2) - mean * mean;
    EXPECT_NEAR(moment(0), 1, 1e-6) << law;
    EXPECT_NEAR(mean, kTime * impulses.rate_times_moment(1), 1e-6) << law;
    EXPECT_NEAR(variance, 1 + kTime * impulses.rate_times_moment(2), 1e-5) << law;
    EXPECT_NEAR(moment(3) - 3 * mean * variance - mean * mean * mean,
                kTime * impulses.rate_times_moment(3), 2e-4)
        << law;
  }
}

TEST(KickMatrix, DependsOnTheFactorOfImpulses) {
  auto problem = tests::with_impulses(kSystem, tests::gaussian_impulses(1, 0.2));
  const auto splines = interpolation();
  const auto unit = kick_matrix(problem, DensityEquation::white, 0, 0.4, splines);
  problem.impulse_factor = problem::StateFunction(problem::Expression::parse("y", {}, "factor"));
  EXPECT_TRUE(kick_matrix(problem, DensityEquation::white, -1, 0.4, splines).isApprox(unit, 1e-12));
  EXPECT_TRUE(kick_matrix(problem, DensityEquation::kf, 0, 0.4, splines).isIdentity(1e-12));
}

}  // namespace
}  // namespace fpkcheck::path_integration
