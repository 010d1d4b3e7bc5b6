#include "problem/impulse_law.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <string>

#include "base/input_error.hpp"
#include "exact/law_transforms.hpp"
#include "laws.hpp"

namespace fpkcheck::problem {
namespace {

const std::vector<ImpulseLaw> kLaws{
    ImpulseLaw(GaussianLaw{0, 0.7}),
    ImpulseLaw(GaussianLaw{0.3, 0.5}),
    ImpulseLaw(LaplaceLaw{0, 0.4}),
    ImpulseLaw(LaplaceLaw{-0.3, 0.5}),
    ImpulseLaw(TwoPointLaw{0, 0.6}),
    ImpulseLaw(TwoPointLaw{0.2, 0.5}),
    ImpulseLaw(UniformLaw{0, 0.8}),
    ImpulseLaw(UniformLaw{0.9, 0.5}),
    ImpulseLaw::from_name("laplace", 0.1, 0.6),
    ImpulseLaw(ExponentialLaw{0, 0.4}),
    ImpulseLaw(ExponentialLaw{0.2, -0.6}),
    ImpulseLaw(GammaLaw{0, 0.7, 2}),
    ImpulseLaw(GammaLaw{-0.3, 0.5, -1.3}),
    ImpulseLaw(GammaLaw{0.1, 0.4, 0.01}),
    ImpulseLaw::from_name("gamma", 0.2, 0.6),
    ImpulseLaw::from_name("tabulated", 0.2, 0.6, {.table = tests::kAtoms}),
    ImpulseLaw::from_name("tabulated", -0.1, 0.5, {.table = tests::kDensity}),
    ImpulseLaw::from_name("tabulated", -0.1, 0.5, {.table = tests::kDensity})
        .with_negated_amplitudes()};

std::string label(const ImpulseLaw& law) {
  return std::string(law.name()) + " about " + std::to_string(law.mean());
}

// Relative contribution to E[Y^6] of the tails beyond the smooth pieces: for the laplace law
// 42^6 exp(-42) / 6! = 4e-12.
constexpr double kCutOff = 1e-11;

// E[f(Y)], computed from the density on its smooth pieces and from the atoms.
std::complex<double> expectation(const ImpulseLaw& law,
                                 const std::function<std::complex<double>(double)>& f) {
  constexpr int kPanels = 40;
  std::complex<double> sum = 0;
  for (const auto& [amplitude, probability] : law.amplitude_atoms())
    sum += probability * f(amplitude);
  const auto pieces = law.amplitude_density_breakpoints();
  for (std::size_t n = 0; n + 1 < pieces.size(); ++n) {
    const double width = (pieces[n + 1] - pieces[n]) / kPanels;
    for (int panel = 0; panel < kPanels; ++panel) {
      const double from = pieces[n] + panel * width;
      const auto integrand = [&](double y) { return law.density(y) * f(y); };
      sum += boost::math::quadrature::gauss<double, 20>::integrate(integrand, from, from + width);
    }
  }
  return sum;
}

TEST(ImpulseLaw, MomentsAreThoseOfDensityAndAtoms) {
  for (const auto& law : kLaws) {
    for (int j = 0; j < kMomentCount; ++j) {
      const double exact = expectation(law, [&](double y) { return std::pow(y, j); }).real();
      EXPECT_NEAR(law.moment(j), exact, kCutOff * (1 + law.moment(6)))
          << label(law) << ", E[Y^" << j;
    }
  }
}

TEST(ImpulseLaw, MeanAndDeviationAreThoseOfTheMoments) {
  for (const auto& law : kLaws) {
    EXPECT_EQ(law.mean(), law.moment(1)) << label(law);
    EXPECT_NEAR(law.amplitude_standard_deviation(),
                std::sqrt(law.moment(2) - law.moment(1) * law.moment(1)), 1e-15)
        << label(law);
  }
}

TEST(ImpulseLaw, CharacteristicAndGeneratingFunctionsAreThoseOfDensityAndAtoms) {
  for (const auto& law : kLaws) {
    for (const double u : {0.0, 1e-5, 0.4, -1.3, 7.0}) {
      const auto wave = [&](double y) { return std::polar(1.0, u * y); };
      EXPECT_LT(std::abs(exact::characteristic_function(law, u) - expectation(law, wave)), 1e-13)
          << label(law) << ", u = " << u;
    }
    for (const double u : {0.0, 0.4, -0.7}) {
      const double exact = expectation(law, [&](double y) { return std::exp(u * y); }).real();
      EXPECT_NEAR(exact::moment_generating_function(law, u), exact, kCutOff)
          << label(law) << ", u = " << u;
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(exact::moment_generating_function(ImpulseLaw(LaplaceLaw{0, 0.5}), -2), infinity);
  EXPECT_EQ(exact::moment_generating_function(ImpulseLaw(ExponentialLaw{0, -0.5}), -2), infinity);
  EXPECT_EQ(exact::moment_generating_function(ImpulseLaw(GammaLaw{0, 1, 1}), 2), infinity);
}

// P(Y <= y) increases over each piece by the integral of the density, from nearly 0 to nearly 1.
TEST(ImpulseLaw, CumulativeIsTheIntegralOfTheDensity) {
  for (const auto& law : kLaws) {
    const auto pieces = law.amplitude_density_breakpoints();
    if (pieces.empty()) continue;
    EXPECT_NEAR(law.cumulative_probability(pieces.front()), 0, 1e-17) << label(law);
    EXPECT_NEAR(law.cumulative_probability(pieces.back()), 1, 1e-15) << label(law);
    for (std::size_t n = 0; n + 1 < pieces.size(); ++n) {
      double from = pieces[n];
      for (const double share : {0.02, 0.1, 0.5, 1.0}) {
        const double to = std::lerp(pieces[n], pieces[n + 1], share);
        double mass = 0;
        for (int part = 0; part < 40; ++part) {
          mass += boost::math::quadrature::gauss<double, 20>::integrate(
              [&](double y) { return law.density(y); }, std::lerp(from, to, part / 40.0),
              std::lerp(from, to, (part + 1) / 40.0));
        }
        EXPECT_NEAR(law.cumulative_probability(to) - law.cumulative_probability(from), mass, 1e-13)
            << label(law) << " to " << to;
        from = to;
      }
    }
  }
}

TEST(ImpulseLaw, TheMirroredLawIsThatOfTheOtherSign) {
  for (const auto& law : kLaws) {
    const ImpulseLaw mirrored = law.with_negated_amplitudes();
    EXPECT_EQ(mirrored.name(), law.name());
    EXPECT_EQ(mirrored.amplitude_standard_deviation(), law.amplitude_standard_deviation())
        << label(law);
    EXPECT_EQ(mirrored.is_symmetric(), law.is_symmetric());
    for (int j = 0; j < kMomentCount; ++j) {
      EXPECT_EQ(mirrored.moment(j), (j % 2 == 0 ? 1 : -1) * law.moment(j)) << label(law);
    }
    for (const double y : {-1.0, -0.2, 0.0, 0.123, 0.7}) {
      EXPECT_NEAR(mirrored.density(y), law.density(-y), 1e-14) << label(law);
      if (law.amplitude_atoms().empty()) {
        EXPECT_NEAR(mirrored.cumulative_probability(y), 1 - law.cumulative_probability(-y), 1e-14)
            << label(law);
      }
      EXPECT_EQ(mirrored.with_negated_amplitudes().density(y), law.density(y)) << label(law);
      EXPECT_EQ(mirrored.with_negated_amplitudes().cumulative_probability(y),
                law.cumulative_probability(y))
          << label(law);
    }
    EXPECT_LT(std::abs(exact::characteristic_function(mirrored, 1.7) -
                       std::conj(exact::characteristic_function(law, 1.7))),
              1e-15);
    EXPECT_EQ(mirrored.with_negated_amplitudes().amplitude_density_breakpoints(),
              law.amplitude_density_breakpoints());
  }
}

TEST(ImpulseLaw, SymmetricLawsAloneHaveNoSkewness) {
  for (const auto& law : kLaws) {
    EXPECT_EQ(law.is_symmetric(), law.skewness() == 0) << label(law);
    const double m = law.mean(), s = law.amplitude_standard_deviation();
    const double third = law.moment(3) - 3 * m * law.moment(2) + 2 * m * m * m;
    EXPECT_NEAR(law.skewness(), third / (s * s * s), 1e-13) << label(law);
  }
  EXPECT_EQ(ImpulseLaw(ExponentialLaw{0.3, -0.5}).skewness(), -2);
  EXPECT_EQ(ImpulseLaw(GammaLaw{0.3, 0.5, -0.7}).skewness(), -0.7);
}

TEST(ImpulseLaw, GammaOfTheSkewnessTwoIsExponential) {
  for (const double sign : {-1.0, 1.0}) {
    const ImpulseLaw gamma(GammaLaw{0.3, 0.5, 2 * sign}), one(ExponentialLaw{0.3, 0.5 * sign});
    for (int j = 0; j < kMomentCount; ++j) EXPECT_NEAR(gamma.moment(j), one.moment(j), 1e-14);
    for (const double y : {-1.3, -0.21, 0.1, 0.79, 1.5}) {
      EXPECT_NEAR(gamma.density(y), one.density(y), 1e-14) << y;
      EXPECT_NEAR(gamma.cumulative_probability(y), one.cumulative_probability(y), 1e-15) << y;
    }
  }
}

TEST(ImpulseLaw, QuantilesOfTheGammaLawInvertItsCumulative) {
  for (const double skewness : {0.01, 0.6, 1.0, 1.7, 2.0}) {
    const GammaLaw law{0, 1, skewness};
    for (const double p : {1e-6, 1e-4, 0.3, 0.5, 0.9}) {
      EXPECT_NEAR(law.cumulative_probability(law.standardised_quantile(p, 1 - p)) / p, 1, 1e-9)
          << skewness << ' ' << p;
    }
    const double far = law.standardised_quantile(1 - 0x1p-40, 0x1p-40);
    EXPECT_NEAR((1 - law.cumulative_probability(far)) * 0x1p40, 1, 1e-3) << skewness;
  }
}

TEST(ImpulseLaw, TakesASkewnessWhereItHasOne) {
  EXPECT_EQ(ImpulseLaw::from_name("gamma", 0, 1).skewness(), 1);
  EXPECT_EQ(ImpulseLaw::from_name("gamma", 0, 1, {.skewness = -0.3}).skewness(), -0.3);
  EXPECT_EQ(ImpulseLaw::from_name("exponential", 0, 1).skewness(), 2);
  EXPECT_EQ(ImpulseLaw::from_name("exponential", 0, 1, {.skewness = -2}).skewness(), -2);
  EXPECT_EQ(ImpulseLaw::from_name("laplace", 0, 1, {.skewness = 0}).skewness(), 0);
  for (const auto& [name, skewness] : {std::pair{"laplace", 1.0},
                                       {"exponential", 1.9},
                                       {"gamma", 0.0},
                                       {"gamma", 2.1},
                                       {"gamma", -0.001}}) {
    try {
      ImpulseLaw::from_name(name, 0, 1, {.skewness = skewness});
      ADD_FAILURE() << name << ' ' << skewness;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("impulse.skewness = ")) << error.what();
    }
  }
}

TEST(ImpulseLaw, HasClosedFormMoments) {
  const ImpulseLaw two_point(TwoPointLaw{1, 2});  // -1 or 3
  EXPECT_NEAR(two_point.moment(3), (-1 + 27) / 2.0, 1e-13);
  EXPECT_NEAR(two_point.moment(6), (1 + 729) / 2.0, 1e-12);
  EXPECT_NEAR(ImpulseLaw(LaplaceLaw{0, 0.5}).moment(6), 720 / 64.0, 1e-13);  // 6! b^6
  EXPECT_NEAR(ImpulseLaw(UniformLaw{1, 1}).moment(5), 32 / 6.0, 1e-13);      // on (0, 2)
  EXPECT_NEAR(ImpulseLaw(GaussianLaw{1, 1}).moment(4), 10, 1e-13);
  const ImpulseLaw exponential(ExponentialLaw{1, 1});  // E
  for (int j = 0; j < kMomentCount; ++j)
    EXPECT_NEAR(exponential.moment(j), std::tgamma(j + 1), 1e-12);
  const ImpulseLaw gamma(GammaLaw{4, 2, 1});  // gamma law of shape 4
  for (int j = 0; j < kMomentCount; ++j) {
    EXPECT_NEAR(gamma.moment(j) / (std::tgamma(4 + j) / 6), 1, 1e-14);
  }
}

TEST(ImpulseLaw, DensityIsNegligibleOutsideItsSmoothPieces) {
  for (const auto& law : kLaws) {
    const auto pieces = law.amplitude_density_breakpoints();
    if (pieces.empty()) {
      EXPECT_EQ(law.density(law.amplitude_atoms().front().amplitude), 0.0);
      continue;
    }
    EXPECT_TRUE(law.amplitude_atoms().empty());
    EXPECT_LT(law.density(std::nextafter(pieces.front(), -HUGE_VAL)), 1e-17) << label(law);
    EXPECT_LT(law.density(std::nextafter(pieces.back(), HUGE_VAL)), 1e-17) << label(law);
  }
}

TEST(ImpulseLaw, RejectsInvalidParameters) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ImpulseLaw(GaussianLaw{0, 0}), InputError);
  EXPECT_THROW(ImpulseLaw(LaplaceLaw{nan, 1}), InputError);
  EXPECT_THROW(ImpulseLaw(TwoPointLaw{0, -1}), InputError);
  EXPECT_THROW(ImpulseLaw(UniformLaw{0, HUGE_VAL}), InputError);
  try {
    ImpulseLaw{UniformLaw{0.5, -1}};
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("uniform impulse law with mean 0.5 and half_width -1"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace fpkcheck::problem
