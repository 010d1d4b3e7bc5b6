#include "mcs/impulses/impulse_source.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exact/law_transforms.hpp"
#include "laws.hpp"
#include "numerics/simd/instruction_set.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kDraws = 400000;

// Compares the mean of `draw()` with `exact`, in standard errors.
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
  // Even powers of the two-point law about 0 have no variance.
  EXPECT_NEAR(mean, exact, 4 * error + 1e-12) << what;
}

TEST(ImpulseSource, DrawsWaitingTimesOfThePoissonProcess) {
  const auto problem = tests::make_problem({.rate = 2.5});
  ImpulseSource source(problem.impulses, 1, 0);
  const auto moment = [&](int order) {
    return [&source, order] { return std::pow(source.next_impulse().waiting_time, order); };
  };
  expect_mean(moment(1), 1 / 2.5, "E[t]");
  expect_mean(moment(2), 2 / (2.5 * 2.5), "E[t^2]");
  expect_mean([&] { return source.next_impulse().waiting_time > 1 ? 1.0 : 0.0; }, std::exp(-2.5),
              "P(t > 1)");
}

TEST(ImpulseSource, DrawsAmplitudesWithTheMomentsOfTheLaw) {
  for (const std::string& law : tests::law_names_without_table()) {
    for (const double mean : {0.0, 0.2, -0.2}) {
      SCOPED_TRACE(fmt::format("{} about {}", law, mean));
      const auto problem = tests::make_problem({.mean = mean, .law = law});
      ImpulseSource source(problem.impulses, 2, 0);
      for (const int order : {1, 2, 3, 4, 6}) {
        expect_mean([&] { return std::pow(source.next_impulse().amplitude, order); },
                    problem.impulses.amplitude_law().moment(order), "moment of Y");
      }
    }
  }
}

// The characteristic function tests the centre and the ends of the law, which moments hardly
// resolve.
TEST(ImpulseSource, DrawsAmplitudesWithTheCharacteristicFunctionOfTheLaw) {
  for (const std::string& name : tests::law_names_without_table()) {
    SCOPED_TRACE(name);
    const auto problem = tests::make_problem({.mean = 0.1, .law = name});
    const auto& law = problem.impulses.amplitude_law();
    ImpulseSource source(problem.impulses, 3, 0);
    for (const double wave : {1.0, 4.0, 20.0}) {
      const double u = wave / law.amplitude_standard_deviation();
      const std::complex<double> expected = exact::characteristic_function(law, u);
      expect_mean([&] { return std::cos(u * source.next_impulse().amplitude); }, expected.real(),
                  "E[cos(u Y)]");
      expect_mean([&] { return std::sin(u * source.next_impulse().amplitude); }, expected.imag(),
                  "E[sin(u Y)]");
    }
  }
}

// Compares the frequency of each atom with the probability, in deviations of the binomial law.
TEST(ImpulseSource, DrawsTheAtomsOfATable) {
  const problem::ImpulseTrain train({.arrival_rate = 1,
                                     .law = "tabulated",
                                     .intensity = 0.3,
                                     .mean = 0.1,
                                     .table = tests::kAtoms});
  ImpulseSource source(train, 6, 0), mirrored(train.with_negated_amplitudes(), 6, 0);
  const auto atoms = train.amplitude_law().amplitude_atoms();
  std::vector<int> count(atoms.size());
  for (int n = 0; n < kDraws; ++n) {
    const double y = source.next_impulse().amplitude;
    ASSERT_EQ(mirrored.next_impulse().amplitude, -y);
    const auto atom = std::ranges::find_if(
        atoms, [&](const problem::AmplitudeAtom& a) { return std::abs(a.amplitude - y) < 1e-14; });
    ASSERT_NE(atom, atoms.end()) << y;
    ++count[static_cast<std::size_t>(atom - atoms.begin())];
  }
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    const double p = atoms[k].probability;
    EXPECT_NEAR(count[k], p * kDraws, 4 * std::sqrt(kDraws * p * (1 - p))) << k;
  }
}

// Kolmogorov's statistic sqrt(n) sup |F_n - F|; it exceeds 1.95 with probability 1e-3.
TEST(ImpulseSource, DrawsAmplitudesWithTheCumulativeOfLawsOfAnySkewness) {
  const auto train_of = [](const char* law, std::optional<double> skewness) {
    const auto table = skewness ? std::nullopt : std::optional<std::string>(tests::kDensity);
    return problem::ImpulseTrain({.arrival_rate = 1,
                                  .law = law,
                                  .intensity = 0.3,
                                  .mean = 0.1,
                                  .skewness = skewness,
                                  .table = table});
  };
  for (const auto& train :
       {train_of("exponential", 2), train_of("exponential", -2), train_of("gamma", 0.01),
        train_of("gamma", -0.5), train_of("gamma", 1.6), train_of("gamma", -2),
        train_of("tabulated", {}), train_of("tabulated", {}).with_negated_amplitudes()}) {
    SCOPED_TRACE(
        fmt::format("{} {}", train.amplitude_law().name(), train.amplitude_law().skewness()));
    ImpulseSource source(train, 5, 0);
    std::vector<double> drawn(kDraws);
    for (double& y : drawn) y = source.next_impulse().amplitude;
    std::ranges::sort(drawn);
    double largest = 0;
    for (int n = 0; n < kDraws; ++n) {
      const double exact =
          train.amplitude_law().cumulative_probability(drawn[static_cast<std::size_t>(n)]);
      largest = std::max({largest, exact - n / double{kDraws}, (n + 1) / double{kDraws} - exact});
    }
    EXPECT_LT(largest * std::sqrt(kDraws), 1.95);
    EXPECT_GT(largest * std::sqrt(kDraws), 0.3);
  }
}

TEST(ImpulseSource, PiecesAreTheQuantilesToTheirTails) {
  for (const double skewness : {0.01, 0.7, 1.9, 2.0}) {
    const problem::GammaLaw law{0, 1, skewness};
    const PiecewiseQuantileFunction pieces = interpolate_quantile_function(
        [&](double p, double q) { return law.standardised_quantile(p, q); });
    for (const double p :
         {0x1p-44, 1e-12, 1e-5, 0.03, 0.24, 0.5, 0.8, 0.97, 1 - 1e-6, 1 - 0x1p-43, 1 - 0x1p-44}) {
      const double exact = law.standardised_quantile(p, 1 - p);
      EXPECT_NEAR(pieces(p), exact, 1e-9 * std::max(1.0, std::abs(exact))) << skewness << ' ' << p;
    }
  }
}

TEST(ImpulseSource, StreamsAndSeedsDoNotShareNumbers) {
  const auto problem = tests::make_problem();
  const auto first = [&](std::uint64_t seed, std::uint32_t stream) {
    return ImpulseSource(problem.impulses, seed, stream).next_impulse().waiting_time;
  };
  EXPECT_EQ(first(1, 0), first(1, 0));
  EXPECT_NE(first(1, 0), first(1, 1));
  EXPECT_NE(first(1, 0), first(2, 0));
  EXPECT_NE(first(1, 0), first(0, 1));
  EXPECT_NE(first(1, 0), first(1 + (std::uint64_t{1} << 32), 0));
}

TEST(ImpulseSource, StreamsAndTheNumbersOfOneImpulseAreUncorrelated) {
  const auto problem = tests::make_problem();
  ImpulseSource a(problem.impulses, 1, 0), b(problem.impulses, 1, 1);
  expect_mean([&] { return a.next_impulse().amplitude * b.next_impulse().amplitude; }, 0, "E[a b]");
  expect_mean(
      [&] {
        const Impulse impulse = a.next_impulse();
        return (impulse.waiting_time - 1) * impulse.amplitude * impulse.amplitude;
      },
      0, "E[(t - 1) Y^2]");
}

TEST(ImpulseSource, GoesOnFromAnyNumber) {
  const auto problem = tests::make_problem({.law = "laplace"});
  ImpulseSource whole(problem.impulses, 9, 4);
  for (int n = 0; n < 50; ++n) {
    ImpulseSource resumed(problem.impulses, 9, 4);
    resumed.seek_to_impulse(whole.drawn_impulse_count());
    EXPECT_EQ(resumed.drawn_impulse_count(), whole.drawn_impulse_count());
    const Impulse expected = whole.next_impulse(), found = resumed.next_impulse();
    EXPECT_EQ(found.waiting_time, expected.waiting_time) << n;
    EXPECT_EQ(found.amplitude, expected.amplitude) << n;
  }
}

TEST(ImpulseSource, StartsAreStandardNormal) {
  const auto problem = tests::make_problem();
  std::uint32_t stream = 0;
  const auto moment = [&](std::size_t which, int order) {
    return [&, which, order] {
      return std::pow(
          ImpulseSource(problem.impulses, 4, stream++).initial_standard_normals()[which], order);
    };
  };
  for (const std::size_t which : {0u, 1u}) {
    expect_mean(moment(which, 1), 0, "E[n]");
    expect_mean(moment(which, 2), 1, "E[n^2]");
    expect_mean(moment(which, 4), 3, "E[n^4]");
  }
}

TEST(ImpulseSource, KicksThatStandForWhiteNoiseComeEvenlyWithItsMeanAndIntensity) {
  const auto problem = tests::make_problem({.rate = 2, .intensity = 0.3, .mean = 0.1});
  const double h = 0.05;
  ImpulseSource source(white_noise_impulse_process(problem.impulses, h), 1, 0);
  const double first = source.next_impulse().waiting_time;
  EXPECT_GT(first, 0);
  EXPECT_LT(first, h);
  EXPECT_EQ(source.next_impulse().waiting_time, h);
  const double mean = 2 * 0.1 * h;
  expect_mean([&] { return source.next_impulse().amplitude; }, mean, "E[Y]");
  expect_mean([&] { return std::pow(source.next_impulse().amplitude - mean, 2); }, 0.3 * h,
              "Var Y");
  expect_mean([&] { return std::pow(source.next_impulse().amplitude - mean, 4); }, 3 * 0.09 * h * h,
              "fourth");
}

// Known-answer tests of Philox4x32-10 from Random123.
TEST(RandomBits, AreThoseOfPhilox) {
  const auto bits =
      random_bits(0xffffffffffffffffull, 0xffffffffu, static_cast<RandomNumberPurpose>(0xffffffffu),
                  0xffffffffffffffffull);
  EXPECT_EQ(bits, (std::array<std::uint32_t, 4>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(random_bits(0, 0, RandomNumberPurpose::impulses, 0),
            (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(UniformNumbers, LieWithinZeroAndOneAndGoOnFromAnyNumber) {
  const UniformRandomNumbers all = uniform_random_numbers(3, 7, RandomNumberPurpose::start, 0),
                             later = uniform_random_numbers(3, 7, RandomNumberPurpose::start, 4);
  for (std::size_t k = 0; k < kImpulsesPerBlock; ++k) {
    for (const double u : {all.first[k], all.second[k], all.third[k]}) {
      EXPECT_GT(u, 0);
      EXPECT_LT(u, 1);
    }
    if (k < 4) continue;
    EXPECT_EQ(all.first[k], later.first[k - 4]);
    EXPECT_EQ(all.second[k], later.second[k - 4]);
    EXPECT_EQ(all.third[k], later.third[k - 4]);
  }
}

TEST(ImpulseBlock, HasTheSameBitsForAnyInstructions) {
  for (const std::string& law : tests::law_names_without_table()) {
    const auto problem = tests::make_problem({.mean = 0.1, .law = law});
    for (const auto& excitation : {poisson_impulse_process(problem.impulses),
                                   white_noise_impulse_process(problem.impulses, 0.05)}) {
      const UniformRandomNumbers u =
          uniform_random_numbers(1, 2, RandomNumberPurpose::impulses, 32);
      const ImpulseBlock expected = baseline::make_impulse_block(excitation, u);
      for (const simd::SimdVariant& lanes : simd::available_simd_variants()) {
        const auto make =
            simd::select_variant(lanes.instructions, baseline::make_impulse_block,
                                 avx2::make_impulse_block, avx512::make_impulse_block);
        const ImpulseBlock block = make(excitation, u);
        EXPECT_EQ(block.waiting_time, expected.waiting_time) << law;
        EXPECT_EQ(block.amplitude, expected.amplitude) << law;
      }
    }
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
