#include "exact/linear_characteristic.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <string>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "exact/law_transforms.hpp"
#include "linear_problem.hpp"

namespace fpkcheck::exact {

using namespace problem;

namespace {

// Direct quadrature of the formula on panels that are short for all laws.
double log_phi(const Problem& problem, double u1, double u2) {
  const double c = problem.system.damping();
  const double w = std::sqrt(problem.system.stiffness() - c * c / 4);
  const auto integrand = [&](double t) {
    const double decay = std::exp(-c * t / 2), sine = std::sin(w * t) / w;
    const double h = decay * sine, h_dot = decay * (std::cos(w * t) - c / 2 * sine);
    return characteristic_function(problem.impulses.amplitude_law(), u1 * h + u2 * h_dot).real() -
           1;
  };
  constexpr double kPanel = 0.02;
  double sum = 0;
  for (int n = 0; n * kPanel < 84 / c; ++n) {
    sum += boost::math::quadrature::gauss<double, 10>::integrate(integrand, n * kPanel,
                                                                 (n + 1) * kPanel);
  }
  return problem.impulses.arrival_rate() * sum;
}

TEST(LinearCharacteristicFunction, EqualsTheQuadratureOfTheFormula) {
  for (const char* law : tests::kSymmetricLaws) {
    for (const double damping : {0.1, 0.9, 1.9}) {
      const Problem p = tests::linear_problem({.damping = damping, .stiffness = 1.3, .law = law});
      const LinearCharacteristicFunction phi(p);
      const double wave[][2] = {{0.1, 0},   {0, 0.1}, {1, -1},     {3, 5},
                                {20, -3.0}, {-7, 40}, {-30, -150}, {400, 2}};
      for (const auto& [u1, u2] : wave) {
        const double exact = log_phi(p, u1, u2);
        // The tolerance includes the rounding errors of the sum over 1e5 panels in log_phi.
        EXPECT_NEAR(phi.logarithm(u1, u2), exact, 2e-13 * (1 + std::abs(exact)))
            << law << ", c = " << damping << ", u = " << u1 << ", " << u2;
      }
    }
  }
}

TEST(LinearCharacteristicFunction, HasTheExactCumulants) {
  for (const char* law : tests::kSymmetricLaws) {
    const Problem p = tests::linear_problem({.law = law});
    const LinearCharacteristicFunction phi(p);
    const double factorial[] = {1, 1, 2, 6, 24, 120, 720};
    const double direction[][2] = {{1, 0}, {0, 1}, {0.6, 0.8}, {0.6, -0.8}};
    for (const auto& [a, b] : direction) {
      for (const double u : {0.1, 0.2}) {
        // log phi(u a, u b) = sum_pq kappa_pq (i u a)^p (i u b)^q / (p! q!), up to order six.
        double series = 0;
        for (int order = 2; order <= 6; order += 2) {
          for (int q = 0; q <= order; ++q) {
            const int n = order - q;
            series += std::pow(-1, order / 2) * linear_cumulant(p, n, q) * std::pow(u * a, n) *
                      std::pow(u * b, q) / (factorial[n] * factorial[q]);
          }
        }
        // Term of order eight: lambda E[Y^8] / 8! int h^8 <= 10 * 2520 s^8 / 8! / 4.
        const double eighth = 10 * 2520 * std::pow(0.1, 4) / 40320 / 4 * std::pow(u, 8);
        EXPECT_NEAR(phi.logarithm(u * a, u * b), series, 1.1 * eighth + 1e-15)
            << law << ", u = " << u << ", direction " << a << ", " << b;
      }
    }
  }
}

TEST(LinearCharacteristicFunction, HasItsMaximumBeyondAnEllipseOnTheEllipse) {
  for (const char* law : tests::kSymmetricLaws) {
    const Problem p = tests::linear_problem({.damping = 0.3, .law = law});
    const LinearCharacteristicFunction phi(p);
    for (double u1 = -40; u1 <= 40; u1 += 6.3) {
      for (double u2 = 0; u2 <= 40; u2 += 5.1) {
        const double radius = phi.radius(u1, u2);
        for (const double inner : {0.5, 0.8, 1.0}) {
          EXPECT_LE(phi(u1, u2), 1.02 * phi.max_beyond(inner * radius)) << law;
        }
      }
    }
    EXPECT_EQ(phi(0, 0), 1.0);
  }
}

TEST(LinearCharacteristicFunction, RefusesOtherProblemsByParameter) {
  const auto expect_refused = [](const tests::Parameters& parameters, const std::string& key) {
    try {
      LinearCharacteristicFunction{tests::make_problem(parameters)};
      FAIL() << "accepted " << key;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(key + " = ")) << error.what();
    }
  };
  expect_refused({.cubic = 0.1, .restitution = 1}, "system.cubic");
  expect_refused({.cubic = 0, .restitution = 0.98}, "system.restitution");
  expect_refused({.damping = 2, .cubic = 0, .restitution = 1}, "system.damping");
  expect_refused({.cubic = 0, .restitution = 1, .mean = 0.1}, "impulse.mean");
}

}  // namespace
}  // namespace fpkcheck::exact
