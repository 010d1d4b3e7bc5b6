#include <benchmark/benchmark.h>

#include <string>

#include "epc/solve.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::benchmarks {
namespace {

using epc::DensityEquation;

// The paper's case `range(0)` at order `range(1)`: root search, assessment of the density, and the
// distance from order n-2.
void solve_gaussian(benchmark::State& state, DensityEquation equation) {
  const auto problem = problem::load_case("case" + std::to_string(state.range(0)));
  const epc::ClosureOptions options{.order = static_cast<int>(state.range(1)),
                                    .equation = equation};
  int iterations = 0;
  for (auto _ : state) iterations = epc::solve_closure(problem, options).summary.iterations;
  state.counters["newton_steps"] = iterations;
}
BENCHMARK_CAPTURE(solve_gaussian, km4, DensityEquation::km4)
    ->ArgsProduct({{1, 2, 3, 4}, {2, 4, 6, 8}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_gaussian, kf, DensityEquation::kf)
    ->ArgsProduct({{1, 2, 3, 4}, {4, 6, 8}})
    ->Unit(benchmark::kMillisecond);

// Without an initial guess: solves all orders from 2 on.
void solve_moment(benchmark::State& state) {
  const auto problem = problem::load_case("case" + std::to_string(state.range(0)));
  const epc::ClosureOptions options{.order = static_cast<int>(state.range(1)),
                                    .formulation = epc::Formulation::moment,
                                    .equation = DensityEquation::kf};
  int iterations = 0;
  for (auto _ : state) iterations = epc::solve_closure(problem, options).summary.iterations;
  state.counters["newton_steps"] = iterations;
}
BENCHMARK(solve_moment)
    ->ArgsProduct({{1, 2, 3, 4}, {2, 4, 6, 8, 10, 12, 16}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fpkcheck::benchmarks
