#include "mcs/deposit/sample_deposit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "base/input_error.hpp"
#include "mcs/deposit/sample_deposit_simd.hpp"
#include "mcs/motion/advance_trajectories.hpp"
#include "mcs/scalar_trajectory.hpp"
#include "mcs/solve.hpp"
#include "numerics/simd/instruction_set.hpp"
#include "paper_cases.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr double kRate = 3, kInterval = 0.25;

std::vector<double> make_knots(double from, double to, int cells, int repeated_middle = 1) {
  std::vector<double> all(5, from);
  for (int k = 0; k <= cells; ++k) {
    const int times = 2 * k == cells ? repeated_middle : 1;
    // Slightly uneven knots, except the middle and the ends.
    const double x = 1.0 * k / cells, t = x + 0.05 * x * (1 - x) * (1 - 2 * x);
    all.insert(all.end(), times, from + (to - from) * t);
  }
  all.insert(all.end(), 5, to);
  return all;
}

SampleDepositionGrid make_deposit_grid() {
  return {.y_knots = make_knots(0, 4, 16),
          .v_knots = make_knots(-5, 5, 40, 3),
          .lattice_begin = -6,
          .lattice_spacing = 0.05,
          .lattice_points = 241,
          .y_bins = {.first = -0.2, .spacing = 0.2, .count = 24},
          .v_bins = {.first = -6, .spacing = 0.4, .count = 31}};
}

/// Coefficients of x^power in the splines, by Marsden's identity: the mean product of `power` of
/// the five inner knots, over all choices.
std::vector<double> spline_coefficients_of_power(const std::vector<double>& knots, int power) {
  std::vector<double> c;
  for (std::size_t i = 0; i + 6 < knots.size(); ++i) {
    std::vector<double> e(static_cast<std::size_t>(power) + 1,
                          0.0);  // elementary symmetric polynomials
    e[0] = 1;
    for (std::size_t k = 1; k <= 5; ++k) {
      for (int p = power; p > 0; --p) e[p] += knots[i + k] * e[p - 1];
    }
    const double choices[] = {1, 5, 10, 10, 5, 1};
    c.push_back(e[power] / choices[power]);
  }
  return c;
}

/// Returns the sum of c_i c_j flow_ij, plus the lattice sums times the values (K v^q)(v) on the
/// lattice.
double generator_mean_of_power(const SampleDepositionGrid& g, const DepositedSampleSums& d, int p,
                               int q, const std::function<double(double)>& after_impulse) {
  const auto in_y = spline_coefficients_of_power(g.y_knots, p),
             in_v = spline_coefficients_of_power(g.v_knots, q);
  double sum = 0;
  for (int i = 0; i < g.y_spline_count(); ++i) {
    for (int j = 0; j < g.v_spline_count(); ++j) {
      sum += in_y[i] * in_v[j] * d.flow[static_cast<std::size_t>(i * d.flow_pitch + j)];
    }
    for (int k = 0; k < g.lattice_points; ++k) {
      sum += in_y[i] * after_impulse(g.lattice_begin + k * g.lattice_spacing) *
             d.lattice[static_cast<std::size_t>(i * d.lattice_pitch + k)];
    }
  }
  return sum;
}

/// Computes the sum of flow and lattice from the scalar trajectory for h = y^p v^q, E[Y] = 0 and
/// E[Y^2] = variance.
struct Tally {
  int p, q;
  double variance;
  double time_to_sample = kInterval / 2, sum = 0, v_before = 0, restitution;
  void on_flight(const tests::Flight& flight, double duration) {
    for (; time_to_sample < duration; time_to_sample += kInterval) {
      const auto [y, v] = flight.state_at_time(time_to_sample);
      const double a = flight.polynomial_acceleration(time_to_sample);
      if (p > 0) sum += v * p * std::pow(y, p - 1) * std::pow(v, q);
      if (q > 0) sum += a * std::pow(y, p) * q * std::pow(v, q - 1);
      if (q >= 2) {  // E[(v + Y)^q] - v^q for q = 2, 3
        sum += kRate * std::pow(y, p) * variance * (q == 2 ? 1 : 3 * v);
      }
    }
    time_to_sample -= duration;
  }
  void on_impact(double v) {
    if (p == 0) sum += (std::pow(-restitution * v, q) - std::pow(v, q)) / kInterval;
  }
  void on_impulse(double, double) {}
};

struct Setting {
  problem::Problem problem = tests::make_problem({.cubic = 1, .restitution = 0.6, .rate = kRate});
  SimulatedOscillator oscillator = tests::oscillator_of(problem);
  BinFinder y{tests::uniform_edges(0, 4, 50)}, v{tests::uniform_edges(-5, 5, 50)};
  SampleDepositionPlan plan{make_deposit_grid(), kRate, kInterval};

  TrajectoryStream advanced(std::uint32_t s, const simd::SimdVariant& lanes) const {
    ImpulseSource source(problem.impulses, 21, s);
    const Impulse first = source.next_impulse();
    TrajectoryStream stream{.branch = {.y = 0.3,
                                       .v = 1 - 0.2 * s,
                                       .time_to_impulse = first.waiting_time,
                                       .amplitude = first.amplitude,
                                       .time_to_sample = kInterval / 2,
                                       .remaining = 0},
                            .source = source,
                            .record = TrajectoryStreamStatistics(y, v)};
    stream.record.deposit = DepositedSampleSums(plan.grid);
    std::vector<TrajectoryStream> copies(static_cast<std::size_t>(lanes.width), stream);
    std::vector<TrajectoryStream*> all;
    for (TrajectoryStream& copy : copies) all.push_back(&copy);
    mcs::advance_all_streams({.oscillator = oscillator,
                              .step = 0.9,
                              .sampling_interval = kInterval,
                              .y_bins = &y,
                              .v_bins = &v,
                              .deposit = &plan},
                             all, 30, lanes);
    return copies.back();
  }
};

TEST(DepositedSums, IsTheGeneratorOnPolynomialsAlongTheTrajectory) {
  const Setting setting;
  const double variance = setting.problem.impulses.amplitude_law().moment(2);
  for (std::uint32_t s = 0; s < 3; ++s) {
    const TrajectoryStream stream = setting.advanced(s, simd::available_simd_variants().back());
    for (const auto& [p, q] :
         {std::pair{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {2, 2}, {0, 3}, {3, 1}}) {
      tests::Trajectory trajectory(setting.oscillator,
                                   ImpulseSource(setting.problem.impulses, 21, s),
                                   {0.3, 1 - 0.2 * s}, 0.9);
      Tally tally{.p = p, .q = q, .variance = variance, .restitution = 0.6};
      trajectory.advance(30, tally);
      const double sum = generator_mean_of_power(
          setting.plan.grid, stream.record.deposit, p, q, [&, power = q](double v) {
            const double more = power == 2 ? variance : power == 3 ? 3 * v * variance : 0;
            return std::pow(v, power) + more;
          });
      EXPECT_NEAR(sum, tally.sum, 1e-9) << p << q;
    }
  }
}

TEST(DepositedSums, TakesShiftsInPlaceOfTheLattice) {
  // The two-point law has the same moments of the generator on all polynomials up to degree 3.
  Setting setting;
  const double variance = setting.problem.impulses.amplitude_law().moment(2),
               d = std::sqrt(variance);
  const DepositedSampleSums lattice =
      setting.advanced(0, simd::available_simd_variants().back()).record.deposit;
  setting.plan.grid.velocity_jumps = {{-d, 0.5}, {d, 0.5}};
  const DepositedSampleSums shifted =
      setting.advanced(0, simd::available_simd_variants().back()).record.deposit;
  EXPECT_EQ(*std::ranges::max_element(shifted.lattice), 0);
  for (const auto& [p, q] : {std::pair{0, 2}, {1, 1}, {2, 2}, {0, 3}}) {
    const auto after = [&, power = q](double v) {
      return (std::pow(v - d, power) + std::pow(v + d, power)) / 2;
    };
    EXPECT_NEAR(generator_mean_of_power(setting.plan.grid, shifted, p, q, after),
                generator_mean_of_power(setting.plan.grid, lattice, p, q, after), 1e-9);
  }
}

TEST(DepositedSums, HasTheSameBitsForAnyWidthAndInstructions) {
  const Setting setting;
  const DepositedSampleSums reference =
      setting.advanced(1, {simd::InstructionSet::baseline, 1}).record.deposit;
  for (const simd::SimdVariant& lanes : simd::available_simd_variants()) {
    SCOPED_TRACE(lanes.width);
    const DepositedSampleSums deposit = setting.advanced(1, lanes).record.deposit;
    EXPECT_EQ(deposit.flow, reference.flow);
    EXPECT_EQ(deposit.lattice, reference.lattice);
    EXPECT_EQ(deposit.y_bins, reference.y_bins);
    EXPECT_EQ(deposit.v_bins, reference.v_bins);
    EXPECT_EQ(deposit.acceleration, reference.acceleration);
    EXPECT_EQ(deposit.impacts, reference.impacts);
    EXPECT_EQ(deposit.impulses, reference.impulses);
  }
}

TEST(DepositedSums, CountsEverySampleInTheSmoothBins) {
  const Setting setting;
  const TrajectoryStream stream = setting.advanced(0, simd::available_simd_variants().back());
  const DepositedSampleSums& deposit = stream.record.deposit;
  const auto sum = [](const std::vector<double>& x) {
    return std::accumulate(x.begin(), x.end(), 0.0);
  };
  EXPECT_NEAR(sum(deposit.y_bins), stream.record.samples, 1e-9);
  EXPECT_NEAR(sum(deposit.v_bins), stream.record.samples, 1e-9);
  // The first moment of M(t) is its centre.
  double first = 0;
  for (std::size_t b = 0; b < deposit.y_bins.size(); ++b) {
    first += deposit.y_bins[b] *
             (-0.2 + 0.2 * (static_cast<double>(b) - DepositedSampleSums::kBinOffset));
  }
  EXPECT_NEAR(first, stream.record.powers[0], 1e-9);
}

TEST(DepositedSums, RecordsImpactsAndImpulses) {
  const Setting setting;
  const TrajectoryStream stream = setting.advanced(0, simd::available_simd_variants().back());
  const auto [before, after, beyond] = stream.record.deposit.impacts;
  EXPECT_GT(stream.record.impacts, 3);
  EXPECT_NEAR(after / before, 0.6, 1e-14);
  EXPECT_LT(beyond, 1e-14 * stream.record.impacts);
  EXPECT_EQ(stream.record.deposit.impulses[0], static_cast<double>(stream.record.impulses));
}

TEST(DepositedSums, DoesNotChangeOtherResults) {
  const auto problem = tests::paper_case(1);
  const SimulationOptions plain{.time = 2e4, .streams = 10};
  SimulationOptions depositing = plain;
  depositing.deposit = make_deposit_grid();
  const SimulationResult a = simulate_stationary_density(problem, plain),
                         b = simulate_stationary_density(problem, depositing);
  EXPECT_TRUE(a.summary.deposits.empty());
  EXPECT_EQ(b.summary.deposits.size(), 10u);
  EXPECT_EQ(a.solution.moments.y2, b.solution.moments.y2);
  EXPECT_EQ(a.solution.standard_errors->moments.v4, b.solution.standard_errors->moments.v4);
  EXPECT_EQ(a.summary.impact_rate.mean, b.summary.impact_rate.mean);
  EXPECT_EQ(a.summary.joint_standard_errors, b.summary.joint_standard_errors);
}

TEST(DepositedSums, RefusesGridsThatItCannotUse) {
  const auto refused = [](const std::function<void(SimulationOptions&)>& change) {
    SimulationOptions options{.deposit = make_deposit_grid()};
    change(options);
    EXPECT_THROW(validate(options), InputError);
  };
  EXPECT_NO_THROW(validate(SimulationOptions{.deposit = make_deposit_grid()}));
  refused([](SimulationOptions& o) { o.equation = DensityEquation::white; });
  refused([](SimulationOptions& o) { o.tails = true; });
  refused([](SimulationOptions& o) { o.deposit->y_knots.erase(o.deposit->y_knots.begin()); });
  refused([](SimulationOptions& o) { o.deposit->v_knots[10] -= 1; });
  refused([](SimulationOptions& o) { o.deposit->lattice_points = 7; });
  refused([](SimulationOptions& o) { o.deposit->y_bins.spacing = 0; });
}

// States with NaN or infinity make a simulation fail, but cause no undefined behaviour.
TEST(DepositLanes, AcceptsNonfiniteAndDistantStates) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInfinity = std::numeric_limits<double>::infinity();
  const SampleDepositionPlan plan(make_deposit_grid(), kRate, kInterval);
  DepositedSampleSums deposit(plan.grid);
  for (const double x : {kNan, -kNan, kInfinity, -kInfinity, 1e300, -1e300}) {
    EXPECT_EQ(evaluate_splines(plan.y, x).first, x > 0 ? 15 : 0) << x;
    deposit_sample(plan, deposit, 1, x, 1, 1);
    deposit_sample(plan, deposit, x, 1, 1, 1);
    deposit_impact(plan, deposit, 0, x, -x, 1);
  }
}

}  // namespace
}  // namespace fpkcheck::mcs
