#include "mcs/impulse_source.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>

#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kDraws = 400000;
constexpr std::array kLaws{"gaussian", "laplace", "two_point", "uniform"};

// The mean of `draw()` against `exact`, in standard errors.
void expect_mean(const std::function<double()>& draw, double exact, const char* what) {
  double sum = 0, sum_of_squares = 0;
  for (int n = 0; n < kDraws; ++n) {
    const double x = draw();
    sum += x;
    sum_of_squares += x * x;
  }
  const double mean = sum / kDraws;
  const double variance = std::max(sum_of_squares / kDraws - mean * mean, 0.0);
  const double error = std::sqrt(variance / kDraws);
  // An amplitude of one size (two points about 0) has even powers without spread.
  EXPECT_NEAR(mean, exact, 4 * error + 1e-12) << what;
}

TEST(ImpulseSource, DrawsWaitingTimesOfThePoissonProcess) {
  const auto problem = tests::make_problem({.rate = 2.5});
  ImpulseSource source(problem.impulses, 1, 0);
  const auto moment = [&](int order) {
    return [&source, order] { return std::pow(source.waiting_time(), order); };
  };
  expect_mean(moment(1), 1 / 2.5, "E[t]");
  expect_mean(moment(2), 2 / (2.5 * 2.5), "E[t^2]");
  expect_mean([&] { return source.waiting_time() > 1 ? 1.0 : 0.0; }, std::exp(-2.5), "P(t > 1)");
}

TEST(ImpulseSource, DrawsAmplitudesWithTheMomentsOfTheLaw) {
  for (const char* law : kLaws) {
    for (const double mean : {0.0, 0.2, -0.2}) {
      SCOPED_TRACE(fmt::format("{} about {}", law, mean));
      const auto problem = tests::make_problem({.mean = mean, .law = law});
      ImpulseSource source(problem.impulses, 2, 0);
      for (const int order : {1, 2, 3, 4, 6}) {
        expect_mean([&] { return std::pow(source.amplitude(), order); },
                    problem.impulses.law().moment(order), "moment of Y");
      }
    }
  }
}

// Where the moments say little: near the middle of the law, and where it ends.
TEST(ImpulseSource, DrawsAmplitudesWithTheCharacteristicFunctionOfTheLaw) {
  for (const char* name : kLaws) {
    SCOPED_TRACE(name);
    const auto problem = tests::make_problem({.mean = 0.1, .law = name});
    const auto& law = problem.impulses.law();
    ImpulseSource source(problem.impulses, 3, 0);
    for (const double wave : {1.0, 4.0, 20.0}) {
      const double u = wave / law.deviation();
      const std::complex<double> exact = law.characteristic_function(u);
      expect_mean([&] { return std::cos(u * source.amplitude()); }, exact.real(), "E[cos(u Y)]");
      expect_mean([&] { return std::sin(u * source.amplitude()); }, exact.imag(), "E[sin(u Y)]");
    }
  }
}

TEST(ImpulseSource, StreamsAndSeedsDoNotShareNumbers) {
  const auto problem = tests::make_problem();
  const auto first = [&](std::uint64_t seed, std::uint32_t stream) {
    return ImpulseSource(problem.impulses, seed, stream).waiting_time();
  };
  EXPECT_EQ(first(1, 0), first(1, 0));
  EXPECT_NE(first(1, 0), first(1, 1));
  EXPECT_NE(first(1, 0), first(2, 0));
  EXPECT_NE(first(1, 0), first(0, 1));
  EXPECT_NE(first(1, 0), first(1 + (std::uint64_t{1} << 32), 0));
}

TEST(ImpulseSource, StreamsAreUncorrelated) {
  const auto problem = tests::make_problem();
  ImpulseSource a(problem.impulses, 1, 0), b(problem.impulses, 1, 1);
  expect_mean([&] { return a.standard_normal() * b.standard_normal(); }, 0, "E[a b]");
}

}  // namespace
}  // namespace fpkcheck::mcs
