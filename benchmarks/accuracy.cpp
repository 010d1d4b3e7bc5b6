#include <benchmark/benchmark.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>

#include "fd_fpk/solve.hpp"
#include "problem/exact.hpp"
#include "setting.hpp"

namespace fpkcheck::benchmarks {
namespace {

using namespace fd_fpk;
using transform::Variable;

double l1(const transform::Marginal& marginal, const std::function<double(double)>& exact) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  double sum = 0;
  for (std::size_t b = 0; b < marginal.size(); ++b) {
    sum += std::abs(marginal.density[b] * marginal.width(b) -
                    Rule::integrate(exact, marginal.edges[b], marginal.edges[b + 1]));
  }
  return sum;
}

// White noise and an elastic impact, where the density is known: case range(0) on range(1) x
// range(2) cells, transport of order range(3), in a box of 5.5 deviations.
void white_noise_against_exact(benchmark::State& state) {
  const auto problem =
      problem::load_case("case" + std::to_string(state.range(0)), {"system.restitution=1"});
  const double k = problem.system.stiffness(), mu = problem.system.cubic();
  const double v2 = 5.5 * 5.5 * problem::exact::mean_square_velocity(problem);
  const Options options{.equation = Equation::white,
                        .stepper = Stepper::direct,
                        .order = static_cast<int>(state.range(3)),
                        .nx = static_cast<int>(state.range(1)),
                        .nv = static_cast<int>(state.range(2)),
                        .x1_max = std::sqrt((std::sqrt(k * k + 2 * mu * v2) - k) / mu),
                        .x2_max = std::sqrt(v2)};
  Result result;
  for (auto _ : state) result = solve(problem, options);
  if (!result.solution.density) {
    state.SkipWithError(result.solution.reason.c_str());
    return;
  }
  const auto& grid = std::get<transform::GridDensity>(*result.solution.density);
  const problem::exact::WhiteNoiseDensity exact(problem);
  state.counters["l1_y"] = l1(marginal(result.solution, Variable::y, grid.y_edges),
                              [&](double y) { return exact.displacement_marginal(y); });
  state.counters["l1_ydot"] = l1(marginal(result.solution, Variable::ydot, grid.v_edges),
                                 [&](double v) { return exact.velocity_marginal(v); });
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
