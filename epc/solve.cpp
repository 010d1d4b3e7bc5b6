#include "epc/solve.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "epc/admissibility.hpp"
#include "epc/gaussian_search.hpp"
#include "epc/projection.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Status;

transform::Solution labelled(const Options& options) {
  const bool white = options.equation == Equation::white;
  transform::Solution solution;
  solution.id = fmt::format("epc-gaussian{}-n{}", white ? "-white" : "", options.order);
  solution.method = "epc";
  solution.equation = white ? "white" : "km4";
  solution.impact = problem::Impact::delta;
  return solution;
}

}  // namespace

void validate(const Options& options) {
  if (options.order < 2 || options.order > kMaxOrder || options.order % 2 != 0) {
    throw InputError(
        fmt::format("epc order = {} (must be an even number from 2 to {}: an odd one cannot fall "
                    "in every direction, and rounding shows in higher ones)",
                    options.order, kMaxOrder));
  }
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw InputError(fmt::format("epc tolerance = {} (no iteration can end) use a positive number",
                                 options.tolerance));
  }
  if (options.max_iterations < 1) {
    throw InputError(fmt::format("epc max_iterations = {} (no step would be taken) use 1 or more",
                                 options.max_iterations));
  }
}

Result solve(const problem::Problem& problem, const Options& options) {
  validate(options);
  const auto start = std::chrono::steady_clock::now();
  const Deviations sigma = deviations(problem::equivalent_linearisation(problem));
  const Projection projection(Basis(options.order, options.monomials, sigma));
  const Search search =
      find_root(projection, residual_coefficients(problem, options.equation), options);

  Result result;
  result.solution = labelled(options);
  result.summary.order = options.order;
  result.summary.formulation = options.formulation;
  result.summary.iterations = search.root.iterations;
  result.summary.residual = search.root.residual;
  if (search.root.converged) {
    judge(problem, projection.basis().polynomial(search.root.a), sigma, result);
  } else {
    result.solution.status = Status::not_converged;
    result.solution.reason = search.failure;
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.solution.seconds = elapsed.count();
  return result;
}

}  // namespace fpkcheck::epc
