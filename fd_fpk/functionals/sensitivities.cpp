#include "fd_fpk/functionals/sensitivities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/functionals/grid_sequence.hpp"
#include "fd_fpk/functionals/shifted_system.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/stationary/parameter_derivatives.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Error of an elasticity at which no finer grid is tried, as a fraction of
// FiniteVolumeOptions::accuracy
constexpr double kElasticityFraction = 0.01;
constexpr Eigen::Index kMomentCount = std::size(transform::kDifferentiatedMoments);

Eigen::VectorXd differentiated_moment_values(const problem::Problem& problem,
                                             const PhasePlaneGrid& grid,
                                             const Eigen::VectorXd& averages, int order) {
  const transform::Moments moments = physical_moments(problem.frame, grid, averages, order);
  Eigen::VectorXd values(kMomentCount);
  for (Eigen::Index k = 0; k < kMomentCount; ++k) {
    values(k) = moments.*transform::kDifferentiatedMoments[k].moment;
  }
  return values;
}

Eigen::Index bin_count(const std::vector<double>& edges) {
  return edges.empty() ? 0 : std::ssize(edges) - 1;
}

Eigen::VectorXd bin_widths(const std::vector<double>& edges) {
  if (edges.empty()) return {};
  const Eigen::Map<const Eigen::VectorXd> all(edges.data(), std::ssize(edges));
  return all.tail(all.size() - 1) - all.head(all.size() - 1);
}

// Returns the moments, then for each parameter the derivatives of all moments, p(y) and p(y').
Eigen::VectorXd sensitivities_on_grid(
    const problem::Problem& problem, const FiniteVolumeOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters,
    const std::vector<double>& y_edges, const std::vector<double>& ydot_edges,
    DirectStationarySolution& direct_solution, const base::Deadline& deadline,
    std::string& failure) {
  const PhasePlaneGrid& grid = direct_solution.discretisation.grid;
  const int order = transport_order(options);
  // The factors of s - L with a small shift s solve the singular systems of L in a few iterations.
  constexpr double kSmallShift = 1e-3;  // in decay rates of the slowest mode
  const ShiftedLinearSystem system(direct_solution.op, &*direct_solution.preconditioner,
                                   grid.v_cell_count(), order,
                                   kSmallShift * direct_solution.scales.slowest_decay_rate);
  const numerics::BlockBandedLu* factors = system.direct_matrix_factors();
  if (factors == nullptr && !direct_solution.preconditioner->factorise_stationary()) {
    failure = direct_solution.preconditioner->failure_reason();
    return {};
  }
  const auto approximate_solve = [&](Eigen::Ref<Eigen::VectorXd> x) {
    if (factors == nullptr) return direct_solution.preconditioner->solve_in_place(x);
    factors->solve_in_place(x);
    x = -x;
  };
  std::vector<double> values;
  const auto append = [&](const auto& more) {
    values.insert(values.end(), more.begin(), more.end());
  };
  append(differentiated_moment_values(problem, grid, *direct_solution.averages, order));
  for (const problem::ParameterDifferenceQuotient& parameter : parameters) {
    const auto [derivative, iterations, reason] = solve_density_derivative(
        direct_solution, generator_derivative_product(problem, options, parameter, direct_solution),
        approximate_solve, deadline);
    if (!derivative) {
      failure = reason;
      return {};
    }
    append(differentiated_moment_values(problem, grid, *derivative, order));
    if (y_edges.empty()) continue;
    const transform::Density density = transform::to_physical_coordinates(
        problem.frame, grid_density_from_averages(grid, *derivative));
    append(transform::marginal(density, transform::StateVariable::y, y_edges).density);
    append(transform::marginal(density, transform::StateVariable::ydot, ydot_edges).density);
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

}  // namespace

transform::MomentSensitivities solve_sensitivities(
    const problem::Problem& problem, const FiniteVolumeOptions& options,
    const std::vector<problem::ParameterDifferenceQuotient>& parameters,
    const std::vector<double>& y_edges, const std::vector<double>& ydot_edges) {
  validate(options);
  const base::Stopwatch stopwatch;
  transform::MomentSensitivities result{.id = solution_id(options)};
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
  FiniteVolumeOptions with_order = options;
  with_order.order = options.order.value_or(automatic_scheme_order(transformed));
  const auto on_grid = [&](DirectStationarySolution& direct_solution,
                           const base::Deadline& deadline, std::string& failure) {
    return sensitivities_on_grid(transformed, with_order, parameters, y_edges, ydot_edges,
                                 direct_solution, deadline, failure);
  };
  // Magnitudes of the moments. E[y] may be 0 and has the magnitude of the root mean square.
  const auto moment_scales = [](const Eigen::VectorXd& moments) -> Eigen::VectorXd {
    Eigen::VectorXd scales(kMomentCount);
    for (Eigen::Index k = 0; k < kMomentCount; ++k) {
      scales(k) = k == 0 ? std::sqrt(moments(1)) : moments(k);
    }
    return scales;
  };
  const Eigen::Index y_bins = bin_count(y_edges), ydot_bins = bin_count(ydot_edges);
  // Returns the index of the first derivative with respect to a parameter in the vector of values.
  const auto first_derivative = [&](std::size_t parameter) {
    return kMomentCount +
           static_cast<Eigen::Index>(parameter) * (kMomentCount + y_bins + ydot_bins);
  };
  // Densities have infinite magnitudes, so that the moments alone determine the grid.
  const auto scale = [&](const Eigen::VectorXd& values) -> Eigen::VectorXd {
    Eigen::VectorXd scales = Eigen::VectorXd::Constant(values.size(), HUGE_VAL);
    const Eigen::VectorXd of_moments = moment_scales(values.head(kMomentCount));
    scales.head(kMomentCount) = of_moments;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const double value = std::abs(parameters[k].value);
      scales.segment(first_derivative(k), kMomentCount) = of_moments / (value > 0 ? value : 1);
    }
    return scales;
  };
  const FunctionalValuesFromGridSequence converged = refine_grids_until_converged(
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
      const Eigen::Index at = first_derivative(k) + m;
      one.derivatives.push_back(converged.values(at));
      one.errors.push_back(converged.errors(at));
    }
    result.expectations.push_back(std::move(one));
  }
  if (!y_edges.empty()) {
    result.marginals = {{.variable = transform::StateVariable::y, .edges = y_edges},
                        {.variable = transform::StateVariable::ydot, .edges = ydot_edges}};
  }
  Eigen::VectorXd inverse_widths(y_bins + ydot_bins);
  inverse_widths << bin_widths(y_edges).cwiseInverse(), bin_widths(ydot_edges).cwiseInverse();
  double density_error = 0;  // largest L1 error of theta dp/dtheta
  for (std::size_t k = 0; k < parameters.size() && !result.marginals.empty(); ++k) {
    // The densities converge more slowly than the moments and have an order of their own.
    const auto densities = [&](const Eigen::VectorXd& all) -> Eigen::VectorXd {
      if (all.size() == 0) return {};
      return all.segment(first_derivative(k) + kMomentCount, y_bins + ydot_bins);
    };
    const Eigen::VectorXd values = densities(converged.values),
                          errors = error_estimates(densities(converged.previous_difference),
                                                   densities(converged.last_difference),
                                                   inverse_widths, transport_order(with_order));
    Eigen::Index at = 0;
    for (transform::MarginalDerivatives& marginal : result.marginals) {
      const auto bins = std::ssize(marginal.edges) - 1;
      const auto part = [&](const Eigen::VectorXd& of_bins) {
        return std::vector<double>(of_bins.begin() + at, of_bins.begin() + at + bins);
      };
      marginal.derivatives.push_back(part(values));
      marginal.errors.push_back(part(errors));
      density_error = std::max(
          density_error, std::abs(parameters[k].value) * marginal.l1_norm(marginal.errors.back()));
      at += bins;
    }
  }
  result.details = fmt::format("{} x {} cells", converged.nx, converged.nv);
  if (!result.marginals.empty()) {
    result.details += fmt::format(
        "; L1 errors of theta dp/dtheta, for p(y) and p(y') and each parameter theta: at most "
        "{:.1e}",
        density_error);
  }
  const double error = std::max(
      (converged.errors.array() / scale(converged.values).array()).maxCoeff(), density_error);
  result.status = Status::ok;
  if (!(error <= options.accuracy)) {
    result.status = Status::inaccurate;
    result.reason = fmt::format(
        "estimated error {:.2g} of an elasticity or of theta dp/dtheta in L1, above the "
        "accuracy {:g}; {}",
        error, options.accuracy, converged.failure);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
