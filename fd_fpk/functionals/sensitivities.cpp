#include "fd_fpk/functionals/sensitivities.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/functionals/grid_sequence.hpp"
#include "fd_fpk/functionals/shifted_system.hpp"
#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/operator/observables.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Error of an elasticity at which no finer grid is tried, as a fraction of Options::accuracy
constexpr double kElasticityFraction = 0.01;
constexpr double kSolverTolerance = 1e-11;
constexpr Eigen::Index kMomentCount = std::size(transform::kDifferentiatedMoments);

Eigen::VectorXd differentiated_moment_values(const problem::Problem& problem, const Grid& grid,
                                             const Eigen::VectorXd& averages, int order) {
  const transform::Moments moments = physical_moments(problem.frame, grid, averages, order);
  Eigen::VectorXd values(kMomentCount);
  for (Eigen::Index k = 0; k < kMomentCount; ++k) {
    values(k) = moments.*transform::kDifferentiatedMoments[k].moment;
  }
  return values;
}

// Returns the moments, then the derivatives of all moments for each parameter.
Eigen::VectorXd sensitivities_on_grid(const problem::Problem& problem, const Options& options,
                                      const std::vector<problem::ParameterDerivative>& parameters,
                                      DirectSolution& direct_solution,
                                      const base::Deadline& deadline, std::string& failure) {
  const Grid& grid = direct_solution.discretisation.grid;
  const int order = transport_order(options);
  const Eigen::VectorXd& p = *direct_solution.averages;
  Eigen::VectorXd values(kMomentCount * static_cast<Eigen::Index>(1 + parameters.size()));
  values.head(kMomentCount) = differentiated_moment_values(problem, grid, p, order);
  // The factors of s - L with a small shift s solve the singular systems of L in a few iterations.
  constexpr double kSmallShift = 1e-3;  // in decay rates of the slowest mode
  const ShiftedSystem system(direct_solution.op, &*direct_solution.preconditioner, grid.nv(), order,
                             kSmallShift * direct_solution.scales.slowest_decay_rate);
  const numerics::BlockBandedLu* factors = system.direct_factors();
  if (factors == nullptr && !direct_solution.preconditioner->factorise_stationary()) {
    failure = direct_solution.preconditioner->failure_reason();
    return {};
  }
  const auto times = [&](const Eigen::VectorXd& x) { return direct_solution.op * x; };
  const auto approximate_solve = [&](Eigen::Ref<Eigen::VectorXd> x) {
    if (factors == nullptr) return direct_solution.preconditioner->solve_in_place(x);
    factors->solve_in_place(x);
    x = -x;
  };
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    Eigen::VectorXd rate = Eigen::VectorXd::Zero(p.size());  // dL p
    for (const auto& [weight, changed] : parameters[k].terms) {
      const problem::Problem transformed = problem::to_wall_coordinates(problem.frame, changed);
      rate += weight * (fokker_planck_operator(transformed, options,
                                               with_excitation_of(transformed, options,
                                                                  direct_solution.discretisation)) *
                        p);
    }
    auto [derivative, iterations, reason] = solve_by_gmres(
        times, approximate_solve, -rate, direct_solution.op.areas, kSolverTolerance, deadline);
    if (!derivative) {
      failure = reason;
      return {};
    }
    *derivative -= direct_solution.op.total_mass(*derivative) * p;
    values.segment(static_cast<Eigen::Index>(k + 1) * kMomentCount, kMomentCount) =
        differentiated_moment_values(problem, grid, *derivative, order);
  }
  return values;
}

}  // namespace

transform::Sensitivities solve_sensitivities(
    const problem::Problem& problem, const Options& options,
    const std::vector<problem::ParameterDerivative>& parameters) {
  validate(options);
  const base::Stopwatch stopwatch;
  transform::Sensitivities result{.id = solution_id(options)};
  for (const auto& parameter : parameters) {
    result.parameters.push_back(parameter.parameter);
    result.parameter_values.push_back(parameter.value);
  }
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  result.reason = transient_unsupported_reason(transformed, options);
  if (!result.reason.empty()) {
    result.status = Status::not_offered;
    return result;
  }
  Options with_order = options;
  with_order.order = options.order.value_or(automatic_scheme_order(transformed));
  const auto on_grid = [&](DirectSolution& direct_solution, const base::Deadline& deadline,
                           std::string& failure) {
    return sensitivities_on_grid(transformed, with_order, parameters, direct_solution, deadline,
                                 failure);
  };
  // Magnitudes of the moments. E[y] may be 0 and has the magnitude of the root mean square.
  const auto moment_scales = [](const Eigen::VectorXd& moments) -> Eigen::VectorXd {
    Eigen::VectorXd scales(kMomentCount);
    for (Eigen::Index k = 0; k < kMomentCount; ++k) {
      scales(k) = k == 0 ? std::sqrt(moments(1)) : moments(k);
    }
    return scales;
  };
  const auto scale = [&](const Eigen::VectorXd& values) -> Eigen::VectorXd {
    Eigen::VectorXd scales(values.size());
    const Eigen::VectorXd of_moments = moment_scales(values.head(kMomentCount));
    scales.head(kMomentCount) = of_moments;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const double value = std::abs(parameters[k].value);
      scales.segment(static_cast<Eigen::Index>(k + 1) * kMomentCount, kMomentCount) =
          of_moments / (value > 0 ? value : 1);
    }
    return scales;
  };
  const ConvergedValues converged = converge_on_grids(
      transformed, with_order, kElasticityFraction * options.accuracy, on_grid, scale);
  result.seconds = stopwatch.seconds();
  if (converged.values.size() == 0) {
    result.reason = converged.failure;
    return result;
  }
  for (Eigen::Index m = 0; m < kMomentCount; ++m) {
    transform::ExpectationDerivatives one{
        .expectation = transform::kDifferentiatedMoments[m].symbol, .value = converged.values(m)};
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const Eigen::Index at = static_cast<Eigen::Index>(k + 1) * kMomentCount + m;
      one.derivatives.push_back(converged.values(at));
      one.errors.push_back(converged.errors(at));
    }
    result.expectations.push_back(std::move(one));
  }
  result.details = fmt::format("{} x {} cells", converged.nx, converged.nv);
  const double error = (converged.errors.array() / scale(converged.values).array()).maxCoeff();
  result.status = Status::ok;
  if (!(error <= options.accuracy)) {
    result.status = Status::inaccurate;
    result.reason =
        fmt::format("estimated error {:.2g} of an elasticity, above the accuracy {:g}; {}", error,
                    options.accuracy, converged.failure);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
