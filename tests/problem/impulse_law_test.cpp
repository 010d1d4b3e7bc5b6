#include "problem/impulse_law.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <string>

#include "parameters/input_error.hpp"

namespace fpkcheck::problem {
namespace {

const std::vector<ImpulseLaw> kLaws{
    ImpulseLaw(GaussianLaw{0, 0.7}),       ImpulseLaw(GaussianLaw{0.3, 0.5}),
    ImpulseLaw(LaplaceLaw{0, 0.4}),        ImpulseLaw(LaplaceLaw{-0.3, 0.5}),
    ImpulseLaw(TwoPointLaw{0, 0.6}),       ImpulseLaw(TwoPointLaw{0.2, 0.5}),
    ImpulseLaw(UniformLaw{0, 0.8}),        ImpulseLaw(UniformLaw{0.9, 0.5}),
    ImpulseLaw::named("laplace", 0.1, 0.6)};

std::string label(const ImpulseLaw& law) {
  return std::string(law.name()) + " about " + std::to_string(law.mean());
}

// What the far tails add to E[Y^6] beyond the smooth pieces, relative: for the laplace law
// 42^6 exp(-42) / 6! = 4e-12.
constexpr double kCutOff = 1e-11;

// E[f(Y)] from the density on its smooth pieces and the atoms.
std::complex<double> expectation(const ImpulseLaw& law,
                                 const std::function<std::complex<double>(double)>& f) {
  constexpr int kPanels = 40;
  std::complex<double> sum = 0;
  for (const auto& [amplitude, probability] : law.atoms()) sum += probability * f(amplitude);
  const auto pieces = law.smooth_pieces();
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
    EXPECT_NEAR(law.deviation(), std::sqrt(law.moment(2) - law.moment(1) * law.moment(1)), 1e-15)
        << label(law);
  }
}

TEST(ImpulseLaw, CharacteristicAndGeneratingFunctionsAreThoseOfDensityAndAtoms) {
  for (const auto& law : kLaws) {
    for (const double u : {0.0, 1e-5, 0.4, -1.3, 7.0}) {
      const auto wave = [&](double y) { return std::polar(1.0, u * y); };
      EXPECT_LT(std::abs(law.characteristic_function(u) - expectation(law, wave)), 1e-13)
          << label(law) << ", u = " << u;
    }
    for (const double u : {0.0, 0.4, -0.7}) {
      const double exact = expectation(law, [&](double y) { return std::exp(u * y); }).real();
      EXPECT_NEAR(law.moment_generating_function(u), exact, kCutOff) << label(law) << ", u = " << u;
    }
  }
  EXPECT_EQ(ImpulseLaw(LaplaceLaw{0, 0.5}).moment_generating_function(-2),
            std::numeric_limits<double>::infinity());
}

TEST(ImpulseLaw, HasClosedFormMoments) {
  const ImpulseLaw two_point(TwoPointLaw{1, 2});  // -1 or 3
  EXPECT_NEAR(two_point.moment(3), (-1 + 27) / 2.0, 1e-13);
  EXPECT_NEAR(two_point.moment(6), (1 + 729) / 2.0, 1e-12);
  EXPECT_NEAR(ImpulseLaw(LaplaceLaw{0, 0.5}).moment(6), 720 / 64.0, 1e-13);  // 6! b^6
  EXPECT_NEAR(ImpulseLaw(UniformLaw{1, 1}).moment(5), 32 / 6.0, 1e-13);      // on (0, 2)
  EXPECT_NEAR(ImpulseLaw(GaussianLaw{1, 1}).moment(4), 10, 1e-13);
}

TEST(ImpulseLaw, DensityIsNegligibleOutsideItsSmoothPieces) {
  for (const auto& law : kLaws) {
    const auto pieces = law.smooth_pieces();
    if (pieces.empty()) {
      EXPECT_EQ(law.density(law.atoms().front().amplitude), 0.0);
      continue;
    }
    EXPECT_TRUE(law.atoms().empty());
    EXPECT_LT(law.density(std::nextafter(pieces.front(), -HUGE_VAL)), 1e-17) << label(law);
    EXPECT_LT(law.density(std::nextafter(pieces.back(), HUGE_VAL)), 1e-17) << label(law);
  }
}

TEST(ImpulseLaw, RefusesWhatIsNoLaw) {
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
