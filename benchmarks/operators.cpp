#include <benchmark/benchmark.h>

#include "case_on_grid.hpp"
#include "fd_fpk/axis/jump_matrix.hpp"

namespace fpkcheck::benchmarks {
namespace {

using namespace fd_fpk;

void jump_matrix_of_a_line(benchmark::State& state) {
  const auto problem = paper_case(1);
  const int cells = static_cast<int>(state.range(0));
  const GridAxis axis = GridAxis::with_uniform_cells(-5, 10.0 / cells, cells);
  for (auto _ : state)
    benchmark::DoNotOptimize(jump_matrix(axis, problem.impulses.amplitude_law()));
}
BENCHMARK(jump_matrix_of_a_line)->Arg(88)->Arg(176)->Arg(352)->Unit(benchmark::kMillisecond);

void operator_assembly(benchmark::State& state) {
  const CaseOnGrid problem_on_grid(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(problem_on_grid.op());
}
BENCHMARK(operator_assembly)->Arg(4000)->Arg(16000)->Arg(64000)->Unit(benchmark::kMillisecond);

void preconditioner_assembly(benchmark::State& state) {
  const CaseOnGrid problem_on_grid(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(problem_on_grid.preconditioner());
}
BENCHMARK(preconditioner_assembly)
    ->Arg(4000)
    ->Arg(16000)
    ->Arg(64000)
    ->Unit(benchmark::kMillisecond);

void operator_product(benchmark::State& state) {
  const CaseOnGrid problem_on_grid(state.range(0));
  const FokkerPlanckOperator op = problem_on_grid.op();
  const Eigen::VectorXd p =
      initial_gaussian(problem_on_grid.grid(), problem::motion_scales(problem_on_grid.problem));
  for (auto _ : state) benchmark::DoNotOptimize((op * p).eval());
}
BENCHMARK(operator_product)->Arg(4000)->Arg(16000)->Arg(64000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fpkcheck::benchmarks
