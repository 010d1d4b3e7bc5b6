#include <benchmark/benchmark.h>

#include "case_on_grid.hpp"
#include "fd_fpk/solve.hpp"

namespace fpkcheck::benchmarks {
namespace {

using namespace fd_fpk;

// The paper's case `range(0)` for the equation kf with default options, as in `fpkcheck fd`.
void solve_case(benchmark::State& state, StationarySolver stepper) {
  const auto problem = paper_case(state.range(0));
  FiniteVolumeSummary last;
  for (auto _ : state) {
    const FiniteVolumeResult result =
        fd_fpk::solve_stationary_density(problem, {.stepper = stepper});
    if (result.solution.status != transform::Status::ok) {
      state.SkipWithError(result.solution.reason.c_str());
      break;
    }
    last = result.summary;
  }
  state.counters["unknowns"] = last.nx * last.nv;
  state.counters["steps"] = static_cast<double>(last.steps);
  state.counters["setups"] = static_cast<double>(last.factorisations);
  state.counters["krylov_iterations"] = static_cast<double>(last.krylov_iterations);
  state.counters["factor_ms"] = 1e3 * last.factor_seconds;
  state.counters["krylov_ms"] = 1e3 * last.krylov_seconds;
  state.counters["factor_entries"] = static_cast<double>(last.factor_entries);
}
BENCHMARK_CAPTURE(solve_case, direct, StationarySolver::direct)
    ->DenseRange(1, 4)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_case, cvode, StationarySolver::cvode)
    ->DenseRange(1, 4)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fpkcheck::benchmarks
