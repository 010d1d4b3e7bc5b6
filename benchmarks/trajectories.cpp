#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <deque>
#include <functional>
#include <random>
#include <thread>
#include <vector>

#include "mcs/motion/advance_trajectories.hpp"
#include "mcs/motion/duffing_flight.hpp"
#include "problem/case_file.hpp"
#include "problem/motion_scales.hpp"

// Simulation performance for the paper's cases: the program's SIMD simulation against a scalar loop
// of the classical Runge-Kutta method with step 0.05, on the same number of threads. Also the error
// per unit time of both.
//
//   fpkcheck_trajectories [THREADS] [TIME OF EACH THREAD]
namespace fpkcheck::benchmarks {
namespace {

constexpr double kRungeKuttaStep = 0.05;
constexpr double kStep = 0.9;  // longest flight of the simulation, in radians
constexpr int kStreams = 8;    // number of streams per thread

using mcs::OscillatorState;

OscillatorState slope(const problem::System& s, const OscillatorState& x) {
  return {x.v, -(s.damping() * x.v + s.restoring_force()(x.y))};
}

OscillatorState runge_kutta(const problem::System& s, const OscillatorState& x, double h) {
  const OscillatorState a = slope(s, x);
  const OscillatorState b = slope(s, {x.y + h / 2 * a.y, x.v + h / 2 * a.v});
  const OscillatorState c = slope(s, {x.y + h / 2 * b.y, x.v + h / 2 * b.v});
  const OscillatorState d = slope(s, {x.y + h * c.y, x.v + h * c.v});
  return {x.y + h / 6 * (a.y + 2 * b.y + 2 * c.y + d.y),
          x.v + h / 6 * (a.v + 2 * b.v + 2 * c.v + d.v)};
}

/// The simplest implementation: fixed steps, shortened at impulses and impacts.
/// @return the time average of v^2
double runge_kutta_loop(const problem::Problem& problem, double time, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::exponential_distribution<double> waiting(problem.impulses.arrival_rate());
  std::normal_distribution<double> amplitude(
      problem.impulses.amplitude_law().mean(),
      problem.impulses.amplitude_law().amplitude_standard_deviation());
  OscillatorState x{0.5, 0};
  double time_to_impulse = waiting(engine), sum = 0;
  for (double t = 0; t < time;) {
    double h = std::min(kRungeKuttaStep, time_to_impulse);
    OscillatorState end = runge_kutta(problem.system, x, h);
    if (end.y < 0) {
      // Newton's method for the length of the step that ends at the wall.
      h *= x.y / (x.y - end.y);
      for (int iteration = 0; iteration < 4; ++iteration) {
        end = runge_kutta(problem.system, x, h);
        if (std::abs(end.y) < 1e-10) break;
        h -= end.y / end.v;
      }
      end = {0, end.v < 0 ? -problem.system.restitution() * end.v : end.v};
    }
    sum += h * end.v * end.v;
    x = end;
    t += h;
    time_to_impulse -= h;
    if (time_to_impulse <= 0) {
      x.v += amplitude(engine);
      if (x.y <= 0 && x.v < 0) x.v *= -problem.system.restitution();
      time_to_impulse = waiting(engine);
    }
  }
  return sum / time;
}

std::vector<double> uniform_edges(double from, double to) {
  std::vector<double> edges;
  for (int k = 0; k <= 140; ++k) edges.push_back(from + (to - from) * k / 140);
  return edges;
}

struct SimulationResult {
  double flights;
  double mean_square;
};

SimulationResult simulation_loop(const problem::Problem& problem, double time, unsigned seed,
                                 const simd::SimdVariant& lanes, bool records) {
  const mcs::BinFinder y(uniform_edges(0, 5)), v(uniform_edges(-5, 5));
  const mcs::StreamMotionParameters motion{
      .oscillator = mcs::make_oscillator(problem, problem::motion_scales(problem)),
      .step = kStep,
      .sampling_interval = 0.23,  // about 25 samples per period
      .y_bins = &y,
      .v_bins = &v,
      .records = records};
  std::deque<mcs::TrajectoryStream> streams;
  std::vector<mcs::TrajectoryStream*> pointers;
  for (unsigned s = 0; s < kStreams; ++s) {
    mcs::ImpulseSource source(problem.impulses, seed, s);
    const mcs::Impulse first = source.next_impulse();
    streams.push_back({.branch = {.y = 0.5,
                                  .v = 0,
                                  .time_to_impulse = first.waiting_time,
                                  .amplitude = first.amplitude,
                                  .time_to_sample = 0.1,
                                  .remaining = 0},
                       .source = source,
                       .record = mcs::TrajectoryStreamStatistics(y, v)});
    pointers.push_back(&streams.back());
  }
  mcs::advance_all_streams(motion, pointers, time / kStreams, lanes);
  SimulationResult result{0, 0};
  double samples = 0;
  for (const mcs::TrajectoryStream& stream : streams) {
    result.flights += static_cast<double>(stream.record.flights);
    result.mean_square += stream.record.powers[4];
    samples += stream.record.samples;
  }
  result.mean_square /= samples;
  return result;
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Simulated time per second of all threads together, the best of three runs. Each thread measures
/// its own processor time, to reduce the influence of other load.
double simulated_time_per_second(int threads, double time,
                                 const std::function<void(unsigned)>& work) {
  double best = 0;
  for (int repetition = 0; repetition < 3; ++repetition) {
    std::vector<double> rates(static_cast<std::size_t>(threads));
    {
      std::vector<std::jthread> others;
      for (unsigned t = 0; t < rates.size(); ++t) {
        others.emplace_back([&, t] {
          const double begin = processor_seconds();
          work(t);
          rates[t] = time / (processor_seconds() - begin);
        });
      }
    }
    double sum = 0;
    for (const double rate : rates) sum += rate;
    best = std::max(best, sum);
  }
  return best;
}

/// Root mean square and maximum of the error of a step from stationary states, relative to the
/// amplitude sqrt(2 E), per unit time.
template <class Advance>
std::pair<double, double> error_per_time(const problem::Problem& problem,
                                         const mcs::SimulatedOscillator& oscillator,
                                         const OscillatorState& deviation, const Advance& advance) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  double squares = 0, largest = 0;
  constexpr int kStates = 20000;
  for (int n = 0; n < kStates; ++n) {
    const OscillatorState start{std::abs(deviation.y * normal(engine)),
                                deviation.v * normal(engine)};
    const auto [end, time] = advance(start);
    OscillatorState exact = start;
    constexpr int kParts = 64;
    for (int p = 0; p < kParts; ++p)
      exact = mcs::DuffingFlight<double>(oscillator, exact).state_at_time(time / kParts);
    const double energy = start.v * start.v / 2 + problem.system.potential()(start.y);
    const double error =
        std::hypot(end.y - exact.y, end.v - exact.v) / std::sqrt(2 * energy) / time;
    squares += error * error;
    largest = std::max(largest, error);
  }
  return {std::sqrt(squares / kStates), largest};
}

void errors(const problem::Problem& problem, const OscillatorState& deviation) {
  const mcs::SimulatedOscillator oscillator =
      mcs::make_oscillator(problem, problem::motion_scales(problem));
  const auto [rms, largest] =
      error_per_time(problem, oscillator, deviation, [&](const OscillatorState& x) {
        return std::pair{runge_kutta(problem.system, x, kRungeKuttaStep), kRungeKuttaStep};
      });
  // For flights of maximum length; impulses and impacts shorten most flights.
  const auto [rms_lanes, largest_lanes] =
      error_per_time(problem, oscillator, deviation, [&](const OscillatorState& x) {
        const mcs::DuffingFlight<double> flight(oscillator, x);
        const double time = flight.max_flight_duration(kStep);
        return std::pair{flight.state_at_time(time), time};
      });
  fmt::print(
      "{}: error per unit time, rms (largest): RK4 {:.1e} ({:.1e}), longest flights {:.1e} "
      "({:.1e})\n",
      problem.name, rms, largest, rms_lanes, largest_lanes);
}

const char* name(simd::InstructionSet set) {
  switch (set) {
    case simd::InstructionSet::avx512:
      return "AVX-512";
    case simd::InstructionSet::avx2:
      return "AVX2";
    case simd::InstructionSet::baseline:
      break;
  }
  return "baseline";
}

}  // namespace
}  // namespace fpkcheck::benchmarks

int main(int argc, char** argv) {
  using namespace fpkcheck;
  using namespace fpkcheck::benchmarks;
  const int threads = argc > 1 ? std::stoi(argv[1]) : 2;
  const double time = argc > 2 ? std::stod(argv[2]) : 4e6;
  for (int number = 1; number <= 4; ++number) {
    const auto problem = problem::load_case("case" + std::to_string(number));
    const double y[] = {0.63, 1.6, 0.5, 1.06}, v[] = {0.66, 2.08, 0.66, 2.1};
    errors(problem, {y[number - 1], v[number - 1]});
  }
  const auto problem = problem::load_case("case1");
  std::vector<double> found(static_cast<std::size_t>(threads));
  const double plain = simulated_time_per_second(
      threads, time / 10, [&](unsigned t) { found[t] = runge_kutta_loop(problem, time / 10, t); });
  fmt::print("case1, {} threads; steps: simulated time / 0.05\n", threads);
  fmt::print("scalar RK4 loop                   {:.2e} steps/s   E[v^2] {:.4f}\n",
             plain / kRungeKuttaStep, found[0]);
  for (const auto& lanes : simd::available_simd_variants()) {
    for (const bool records : {false, true}) {
      std::vector<SimulationResult> results(static_cast<std::size_t>(threads));
      const double rate = simulated_time_per_second(threads, time, [&](unsigned t) {
        results[t] = simulation_loop(problem, time, t, lanes, records);
      });
      fmt::print("{:8} {} lanes, {:16} {:.2e} steps/s, {:5.2f} of RK4", name(lanes.instructions),
                 lanes.width, records ? "with histogram" : "motion alone", rate / kRungeKuttaStep,
                 rate / plain);
      if (records) {
        fmt::print("   E[v^2] {:.4f}, {:.2e} flights/s", results[0].mean_square,
                   rate * results[0].flights / time);
      }
      fmt::print("\n");
    }
  }
}
