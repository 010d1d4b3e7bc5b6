#include "methods/external/external_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/input_error.hpp"
#include "methods/external/bin_average_errors.hpp"
#include "methods/external/range_between_walls.hpp"
#include "numerics/statistics.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::StateVariable;
using transform::Status;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Samples of (y, y') with the effective number of independent samples.
struct StateSamples {
  std::vector<double> y, v;
  double independent;

  std::size_t size() const { return y.size(); }
};

std::optional<std::size_t> bin_index(const std::vector<double>& edges, double value) {
  if (!(value >= edges.front() && value < edges.back())) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::upper_bound(edges, value) - edges.begin()) - 1;
}

StateSamples without_samples_at_rest(const StateSamples& samples, const problem::Problem& problem) {
  if (!problem::problem_features(problem).rests_in_contact) return samples;
  const problem::Walls walls = problem.system.walls();
  StateSamples left{{}, {}, samples.independent};
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double y = samples.y[k];
    if (samples.v[k] == 0 && (is_at_wall(walls.left, y) || is_at_wall(walls.right, y))) continue;
    left.y.push_back(y);
    left.v.push_back(samples.v[k]);
  }
  return left;
}

// Adds a marginal density to the solution, from the fractions of all `n` samples in each bin, with
// confidence intervals from the standard errors of the fractions.
void add_marginal(const std::vector<double>& edges, const std::vector<double>& values, double n,
                  double independent, StateVariable variable, Solution& solution) {
  std::vector<double> fractions(edges.size() - 1);
  for (const double value : values) {
    if (const auto bin = bin_index(edges, value)) fractions[*bin] += 1 / n;
  }
  transform::Marginal marginal{edges, {}, {}, {}};
  std::vector<BinAverageError> errors;
  for (std::size_t b = 0; b < fractions.size(); ++b) {
    const double width = edges[b + 1] - edges[b], density = fractions[b] / width;
    const double error = std::sqrt(fractions[b] * (1 - fractions[b]) / independent) / width;
    marginal.density.push_back(density);
    marginal.lower.push_back(std::max(0.0, density - numerics::kNormal95 * error));
    marginal.upper.push_back(density + numerics::kNormal95 * error);
    errors.push_back({width, b, {error}});
  }
  const auto [expected, quantile_99] = l1_sampling_error(errors);
  auto& sampling = solution.sampling ? *solution.sampling : solution.sampling.emplace();
  (variable == StateVariable::y ? sampling.y : sampling.ydot) = expected;
  (variable == StateVariable::y ? sampling.y_99 : sampling.ydot_99) = quantile_99;
  solution.estimated_marginals.emplace_back(variable, std::move(marginal));
}

void set_moments(const StateSamples& samples, Solution& solution) {
  constexpr int kPowers[] = {1, 2, 4, 1, 2, 4};  // three powers of y, then three powers of y'
  static_assert(std::size(kPowers) == std::size(transform::kMoments));
  const double n = static_cast<double>(samples.size());
  for (std::size_t k = 0; k < std::size(kPowers); ++k) {
    const auto moment = transform::kMoments[k].moment;
    const auto& values = k < 3 ? samples.y : samples.v;
    double sum = 0, squares = 0;
    for (const double value : values) sum += std::pow(value, kPowers[k]);
    const double mean = sum / n;
    for (const double value : values) squares += std::pow(std::pow(value, kPowers[k]) - mean, 2);
    solution.moments.*moment = mean;
    solution.standard_errors->moments.*moment = std::sqrt(squares / n / samples.independent);
  }
}

Solution samples_solution(const StateSamples& samples, const problem::Problem& problem,
                          const compare::ComparisonBins& axes) {
  Solution solution;
  solution.status = Status::ok;
  solution.energy_residual = kUnknown;
  solution.standard_errors.emplace().energy_residual = kUnknown;
  transform::GridDensity grid{axes.y_edges, axes.v_edges, {}};
  grid.averages.assign(grid.y_cell_count() * grid.v_cell_count(), 0.0);
  const double n = static_cast<double>(samples.size()), each = 1 / n;
  const StateSamples value_from_count = without_samples_at_rest(samples, problem);
  for (std::size_t k = 0; k < value_from_count.size(); ++k) {
    const auto i = bin_index(grid.y_edges, value_from_count.y[k]),
               j = bin_index(grid.v_edges, value_from_count.v[k]);
    if (!i || !j) continue;
    solution.mass += each;
    grid.averages[*i * grid.v_cell_count() + *j] +=
        each /
        ((grid.y_edges[*i + 1] - grid.y_edges[*i]) * (grid.v_edges[*j + 1] - grid.v_edges[*j]));
  }
  solution.density = std::move(grid);
  add_marginal(axes.y_edges, value_from_count.y, n, samples.independent, StateVariable::y,
               solution);
  add_marginal(axes.v_edges, value_from_count.v, n, samples.independent, StateVariable::ydot,
               solution);
  set_moments(samples, solution);
  transform::SolverMetricsBuilder builder;
  builder.add_diagnostic_metric("samples", transform::value_from_count(samples.size()))
      .add_diagnostic_metric("independent", samples.independent);
  add_rest_atom_note(problem, builder);
  solution.metrics = builder.take_metrics();
  return solution;
}

}  // namespace

Method make_method_from_samples(const ExternalDensity& external, std::span<const double> y,
                                std::span<const double> v, double independent) {
  constexpr std::size_t kMinSamples = 100;
  const auto refuse = [label = external.label](const std::string& why) {
    throw InputError(fmt::format("samples '{}': {}", label, why));
  };
  if (y.size() != v.size())
    refuse(fmt::format("{} of y and {} of y' (must be equal)", y.size(), v.size()));
  if (y.size() < kMinSamples)
    refuse(fmt::format("{} pairs (must be at least {})", y.size(), kMinSamples));
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!std::isfinite(y[k]) || !std::isfinite(v[k])) {
      refuse(fmt::format("y = {:.4g}, y' = {:.4g} (must be finite)", y[k], v[k]));
    }
  }
  const auto all = static_cast<double>(y.size());
  if (!(independent >= 0 && independent <= all)) {
    refuse(fmt::format("independent = {:g} (must be 0 .. {}, the number of samples)", independent,
                       y.size()));
  }
  auto samples = std::make_shared<const StateSamples>(StateSamples{
      {y.begin(), y.end()}, {v.begin(), v.end()}, independent > 0 ? independent : all});
  return {.identity = make_external_density_identity(external, transform::kExternalFunction,
                                                     "given as samples"),
          .solve =
              [samples](const problem::Problem& problem, const SolverInputContext& context) {
                return samples_solution(*samples, problem, context.axes);
              },
          .check =
              [samples, refuse](const problem::Problem& problem) {
                const problem::Walls walls = problem.system.walls();
                for (std::size_t k = 0; k < samples->size(); ++k) {
                  if (is_between_walls(walls, samples->y[k])) continue;
                  refuse(fmt::format("y = {:.4g}, y' = {:.4g} (must be {})", samples->y[k],
                                     samples->v[k], admissible_range_text(walls)));
                }
              }};
}

}  // namespace fpkcheck::methods
