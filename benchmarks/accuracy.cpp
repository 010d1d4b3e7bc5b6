#include <benchmark/benchmark.h>

#include "case_on_grid.hpp"
#include "elastic_white_noise.hpp"
#include "fd_fpk/solve.hpp"

namespace fpkcheck::benchmarks {
namespace {

// White noise and an elastic impact, where the density is known exactly. Case range(0) on range(1)
// x range(2) cells, transport of order range(3), in a box of 5.5 standard deviations.
void white_noise_against_exact(benchmark::State& state) {
  const auto problem =
      problem::load_case("case" + std::to_string(state.range(0)), {"system.restitution=1"});
  const auto options = tests::elastic_white_noise_exponent(
      problem, static_cast<int>(state.range(3)), static_cast<int>(state.range(1)),
      static_cast<int>(state.range(2)));
  fd_fpk::FiniteVolumeResult result;
  for (auto _ : state) result = fd_fpk::solve_stationary_density(problem, options);
  if (!result.solution.density) {
    state.SkipWithError(result.solution.reason.c_str());
    return;
  }
  const auto [y, ydot] = tests::errors_of(result.solution, problem);
  state.counters["l1_y"] = y;
  state.counters["l1_ydot"] = ydot;
  state.counters["krylov_iterations"] = static_cast<double>(result.summary.krylov_iterations);
  state.counters["factor_entries"] = static_cast<double>(result.summary.factor_entries);
}
BENCHMARK(white_noise_against_exact)
    ->ArgNames({"case", "nx", "nv", "order"})
    ->ArgsProduct({{1, 2, 3, 4}, {24}, {48}, {7}})
    ->ArgsProduct({{1, 2, 3, 4}, {40}, {80}, {5, 6, 7, 8}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fpkcheck::benchmarks
