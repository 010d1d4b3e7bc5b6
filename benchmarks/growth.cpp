#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <ctime>

#include "case_on_grid.hpp"
#include "fd_fpk/solve.hpp"

namespace fpkcheck::benchmarks {
namespace {

using namespace fd_fpk;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Scaling of time and memory with the number of unknowns: kf, case 1, direct, on about range(0)
// cells. Peak memory is that of the process since its start: run this benchmark alone. `exponent`
// is d log(time) / d log(unknowns) relative to the previous grid.
void growth(benchmark::State& state) {
  static double unknowns_before = 0, seconds_before = 0;
  const auto problem = paper_case(1);
  FiniteVolumeOptions options = options_for(state.range(0));
  const PhasePlaneBox box = initial_box(problem, options);
  options.x1_max = box.x1_max;
  options.x2_max = box.x2_max;
  FiniteVolumeResult result;
  double seconds = HUGE_VAL;
  for (auto _ : state) {
    const double begin = cpu_seconds();
    result = solve_stationary_density(problem, options);
    seconds = std::min(seconds, cpu_seconds() - begin);
  }
  if (result.solution.status != transform::Status::ok) {
    state.SkipWithError(result.solution.reason.c_str());
    return;
  }
  const FiniteVolumeSummary& summary = result.summary;
  const double unknowns = summary.nx * summary.nv;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["unknowns"] = unknowns;
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
  state.counters["krylov_iterations"] = static_cast<double>(summary.krylov_iterations);
  state.counters["factor_entries"] = static_cast<double>(summary.factor_entries);
  state.counters["factor_s"] = summary.factor_seconds;
  state.counters["krylov_s"] = summary.krylov_seconds;
  if (unknowns_before > 0) {
    state.counters["exponent"] =
        std::log(seconds / seconds_before) / std::log(unknowns / unknowns_before);
  }
  unknowns_before = unknowns;
  seconds_before = seconds;
  state.SetComplexityN(static_cast<benchmark::IterationCount>(unknowns));
}
BENCHMARK(growth)
    ->Arg(4000)
    ->Arg(16000)
    ->Arg(64000)
    ->Iterations(2)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace fpkcheck::benchmarks
