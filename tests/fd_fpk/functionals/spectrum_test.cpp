#include "fd_fpk/functionals/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::System;
using transform::SpectralDensity;
using transform::StateVariable;
using transform::Status;

void expect_within_errors(const SpectralDensity& spectrum, const std::vector<double>& exact,
                          double relative) {
  ASSERT_EQ(spectrum.status, Status::ok) << spectrum.reason;
  ASSERT_EQ(spectrum.density.size(), exact.size());
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const double error = std::abs(spectrum.density[k] - exact[k]);
    EXPECT_LE(error, 2 * spectrum.error[k]) << "w = " << spectrum.frequencies[k];
    EXPECT_LE(error, relative * exact[k]) << "w = " << spectrum.frequencies[k];
  }
}

// Accuracy that the first three grids reach
const FiniteVolumeOptions kCoarse{.accuracy = 0.1};

// The exact spectrum is (2D + lambda E[Y^2]) / (pi ((k - w^2)^2 + c^2 w^2)), one-sided.
TEST(Spectrum, IsThatOfTheLinearOscillatorUnderImpulsesAndNoise) {
  problem::Problem p =
      tests::with_impulses(System({.damping = 0.3, .stiffness = 1.44}, {.none = true}),
                           tests::gaussian_impulses(1, 0.1, 0.1));
  p.noise.intensity = 0.05;
  const std::vector<double> frequencies{0, 0.4, 0.9, 1.2, 1.5, 2, 3};
  std::vector<double> of_y, of_v;
  for (const double w : frequencies) {
    of_y.push_back(0.15 / (std::numbers::pi * (std::pow(1.44 - w * w, 2) + 0.09 * w * w)));
    of_v.push_back(w * w * of_y.back());
  }
  expect_within_errors(solve_spectrum(p, kCoarse, StateVariable::y, frequencies), of_y, 1e-4);
  const SpectralDensity velocity =
      solve_spectrum(p, kCoarse, StateVariable::ydot, {frequencies.begin() + 1, frequencies.end()});
  expect_within_errors(velocity, {of_v.begin() + 1, of_v.end()}, 1e-4);
  EXPECT_NEAR(velocity.variance, 0.15 / (2 * 0.3), 1e-5);
  // The eigenvalues are -(c +- sqrt(c^2 - 4k)) / 2, and no other mode has a share of the variance.
  ASSERT_FALSE(velocity.modes.empty());
  EXPECT_NEAR(velocity.modes[0].decay_rate, 0.15, 1e-5);
  EXPECT_NEAR(velocity.modes[0].frequency, std::sqrt(1.44 - 0.0225), 1e-5);
  EXPECT_NEAR(velocity.modes[0].share, 1, 1e-4);
}

TEST(Spectrum, HasTheAutocovarianceOfTheLinearOscillator) {
  const auto p = tests::with_impulses(System({.damping = 0.3, .stiffness = 1.44}, {.none = true}),
                                      tests::gaussian_impulses(1, 0.1, 0.1));
  const std::vector<double> lags{0, 0.5, 2, 7, 15};
  const double w = std::sqrt(1.44 - 0.0225), of_y = 0.1 / (2 * 0.3 * 1.44), of_v = 0.1 / (2 * 0.3);
  for (const auto variable : {StateVariable::y, StateVariable::ydot}) {
    const SpectralDensity s = solve_spectrum(p, kCoarse, variable, {0.5, 1}, lags);
    ASSERT_EQ(s.autocovariance.size(), lags.size()) << s.reason;
    for (std::size_t k = 0; k < lags.size(); ++k) {
      const double t = lags[k], cosine = std::cos(w * t), sine = 0.15 / w * std::sin(w * t);
      const double exact = variable == StateVariable::y
                               ? of_y * std::exp(-0.15 * t) * (cosine + sine)
                               : of_v * std::exp(-0.15 * t) * (cosine - sine);
      EXPECT_NEAR(s.autocovariance[k], exact, 2 * s.autocovariance_error[k]) << t;
      EXPECT_LT(s.autocovariance_error[k], 1e-4) << t;
    }
  }
}

// With an elastic wall at the equilibrium, y = |z| of the linear oscillator without a wall, with
// the autocovariance (2 s^2/pi) (sqrt(1 - q^2) + q arcsin q - 1), q the autocorrelation of z.
TEST(Spectrum, IsThatOfTheFoldedLinearOscillatorAtAnElasticWall) {
  const double c = 0.4, k = 1, intensity = 0.4, variance = intensity / (2 * c * k);
  const auto p =
      tests::with_noise(System({.damping = c, .stiffness = k, .restitution = 1}), intensity);
  const double w0 = std::sqrt(k - c * c / 4);
  const auto covariance = [&](double t) {
    const double q = std::exp(-c * t / 2) * (std::cos(w0 * t) + c / (2 * w0) * std::sin(w0 * t));
    return 2 * variance / std::numbers::pi * (std::sqrt(1 - q * q) + q * std::asin(q) - 1);
  };
  const std::vector<double> frequencies{0, 0.5, 1, 1.8, 2.5, 3.5};
  std::vector<double> exact;
  for (const double w : frequencies) {
    // Simpson's rule; the covariance has a kink only at t = 0 and decays as exp(-c t).
    constexpr int kIntervals = 40000;
    constexpr double kStep = 80.0 / kIntervals;
    double sum = 0;
    for (int n = 0; n <= kIntervals; ++n) {
      const double weight = n == 0 || n == kIntervals ? 1 : n % 2 == 1 ? 4 : 2;
      // At t = 0 rounding would give the root of a negative number.
      const double value = n == 0 ? variance * (1 - 2 / std::numbers::pi) : covariance(n * kStep);
      sum += weight * value * std::cos(w * n * kStep);
    }
    exact.push_back(2 / std::numbers::pi * sum * kStep / 3);
  }
  const std::vector<double> lags{0.3, 1, 3.5, 8};
  const SpectralDensity spectrum = solve_spectrum(p, {}, StateVariable::y, frequencies, lags);
  expect_within_errors(spectrum, exact, 1e-3);
  for (std::size_t j = 0; j < lags.size(); ++j) {
    const double difference = std::abs(spectrum.autocovariance[j] - covariance(lags[j]));
    EXPECT_LE(difference, 2 * spectrum.autocovariance_error[j]) << lags[j];
    EXPECT_LE(difference, 1e-3 * variance) << lags[j];
  }
}

// The density at few frequencies converges in a Krylov space that does not determine the modes. The
// slowest modes are those of the linear oscillator with two quanta: decay rate c, frequencies 0 and
// 2 sqrt(k - c^2/4).
TEST(Spectrum, StatesTheErrorsOfModesAtFewFrequencies) {
  const double c = 0.1;
  const auto p = tests::with_noise(System({.damping = c, .stiffness = 1, .restitution = 1}), 0.2);
  const SpectralDensity spectrum = solve_spectrum(p, kCoarse, StateVariable::y, {0, 0.75, 1.5});
  ASSERT_EQ(spectrum.modes.size(), 2u) << spectrum.reason;
  const double frequencies[] = {0, 2 * std::sqrt(1 - c * c / 4)};
  for (std::size_t m = 0; m < 2; ++m) {
    const auto& mode = spectrum.modes[m];
    EXPECT_NEAR(mode.decay_rate, c, 2 * mode.decay_rate_error) << m;
    EXPECT_NEAR(std::abs(mode.frequency), frequencies[m], 2 * mode.frequency_error + 1e-12) << m;
    EXPECT_LT(mode.decay_rate_error + mode.frequency_error, 1e-3) << m;
  }
}

// y' is the derivative of y, also with impacts, so that G_v = w^2 G_y.
TEST(Spectrum, OfVelocityIsThatOfDisplacementTimesTheSquaredFrequency) {
  const auto p = tests::make_problem({.damping = 0.3, .restitution = 0.8});
  const std::vector<double> frequencies{0.5, 1, 2.1, 3};
  const SpectralDensity y = solve_spectrum(p, {}, StateVariable::y, frequencies);
  const SpectralDensity v = solve_spectrum(p, {}, StateVariable::ydot, frequencies);
  ASSERT_EQ(y.status, Status::ok) << y.reason;
  ASSERT_EQ(v.status, Status::ok) << v.reason;
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    const double square = frequencies[k] * frequencies[k];
    EXPECT_NEAR(v.density[k], square * y.density[k], 2 * (v.error[k] + square * y.error[k]))
        << frequencies[k];
    EXPECT_NEAR(v.density[k] / (square * y.density[k]), 1, 2e-3) << frequencies[k];
  }
}

TEST(Spectrum, IsNotOfferedWhereTheMassRestsInContact) {
  const auto p =
      tests::with_impulses(System({.damping = 0.1, .stiffness = 1},
                                  problem::WallParameters{.left = 0.5, .left_restitution = 0.5}),
                           tests::gaussian_impulses(1, 0.1));
  const SpectralDensity spectrum = solve_spectrum(p, {}, StateVariable::y, {0, 1});
  EXPECT_EQ(spectrum.status, Status::not_offered);
  EXPECT_FALSE(spectrum.reason.empty());
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
