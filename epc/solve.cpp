#include "epc/solve.hpp"

#include <chrono>

#include "epc/contact/coordinates.hpp"
#include "epc/contact/solve.hpp"
#include "epc/gaussian/solve.hpp"
#include "epc/moment/solve.hpp"
#include "epc/polar/solve.hpp"

namespace fpkcheck::epc {
namespace {

Result solve_formulation(const problem::Problem& problem, const Options& options) {
  switch (options.formulation) {
    case Formulation::gaussian:
      return gaussian::solve(problem, options);
    case Formulation::moment:
      return moment::solve(problem, options);
    case Formulation::polar:
      return contact::is_pressed_on_one_wall(problem) ? contact::solve(problem, options)
                                                      : polar::solve(problem, options);
  }
  return {};
}

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const auto start = std::chrono::steady_clock::now();
  Result result = solve_formulation(problem, options);
  auto& [solution, summary] = result;
  summary.order = options.order;
  summary.formulation = options.formulation;
  solution.identity = identity(options);
  solution.metrics = metrics(summary, summary.moments);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  solution.seconds = elapsed.count();
  return result;
}

}  // namespace fpkcheck::epc
