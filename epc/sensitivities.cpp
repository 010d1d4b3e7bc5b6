#include "epc/sensitivities.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/process/stopwatch.hpp"
#include "epc/solve.hpp"

namespace fpkcheck::epc {
namespace {

using transform::kDifferentiatedMoments;
using transform::Moments;
using transform::Status;

// The moments of a closure and their derivatives with respect to each parameter.
struct ClosureMomentDerivatives {
  Moments moments;
  std::vector<Moments> derivatives = {};
  std::string failure = {};
};

ClosureMomentDerivatives moment_derivatives(
    const problem::Problem& transformed, const ClosureOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters) {
  ClosureMomentDerivatives result;
  // Returns the moments of the closure of a problem; the first closure that fails is recorded.
  const auto moments_of = [&](const problem::Problem& problem, const std::string& changed) {
    const ClosureResult closure = solve_closure(problem, options);
    const auto& solution = closure.solution;
    if (solution.status != Status::ok && result.failure.empty()) {
      result.failure = fmt::format("order {}{}: {}: {}", options.order, changed,
                                   name(solution.status), solution.reason);
    }
    return solution.moments;
  };
  result.moments = moments_of(transformed, "");
  for (const auto& [parameter, value, terms] : parameters) {
    Moments derivative;
    for (const auto& [weight, changed] : terms) {
      if (!result.failure.empty()) return result;
      const Moments moments = moments_of(problem::to_wall_coordinates(transformed.frame, changed),
                                         " with a changed " + parameter);
      for (const auto& moment : kDifferentiatedMoments) {
        derivative.*moment.moment += weight * moments.*moment.moment;
      }
    }
    result.derivatives.push_back(derivative);
  }
  return result;
}

}  // namespace

transform::MomentSensitivities solve_sensitivities(
    const problem::Problem& problem, const ClosureOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters) {
  validate(options);
  const base::Stopwatch stopwatch;
  transform::MomentSensitivities result{.id = solution_id(options)};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  result.reason = unsupported_reason(transformed, options);
  if (!result.reason.empty()) {
    result.status = Status::not_offered;
    return result;
  }
  const ClosureMomentDerivatives found = moment_derivatives(transformed, options, parameters);
  ClosureMomentDerivatives previous;
  if (found.failure.empty() && options.order > 2) {
    ClosureOptions lower = options;
    lower.order -= 2;
    previous = moment_derivatives(transformed, lower, parameters);
  }
  result.seconds = stopwatch.seconds();
  if (!found.failure.empty()) {
    result.status = Status::not_converged;
    result.reason = found.failure;
    return result;
  }
  const bool has_errors =
      previous.failure.empty() && previous.derivatives.size() == parameters.size();
  for (const auto& parameter : parameters) {
    result.parameters.push_back(parameter.parameter);
    result.parameter_values.push_back(parameter.value);
  }
  for (const auto& moment : kDifferentiatedMoments) {
    transform::ExpectationDerivatives one{.expectation = moment.symbol,
                                          .value = found.moments.*moment.moment};
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const double derivative = found.derivatives[k].*moment.moment;
      one.derivatives.push_back(derivative);
      one.errors.push_back(has_errors
                               ? std::abs(derivative - previous.derivatives[k].*moment.moment)
                               : std::numeric_limits<double>::quiet_NaN());
    }
    result.expectations.push_back(std::move(one));
  }
  result.details =
      has_errors ? "errors: differences from order n-2"
                 : "no error estimate" + (previous.failure.empty() ? "" : ": " + previous.failure);
  result.status = Status::ok;
  return result;
}

}  // namespace fpkcheck::epc
