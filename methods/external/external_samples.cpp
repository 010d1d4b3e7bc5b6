#include "methods/external/external_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include "base/input_error.hpp"
#include "methods/external/bin_average_errors.hpp"
#include "methods/external/range_between_walls.hpp"
#include "numerics/block_bootstrap.hpp"
#include "numerics/statistics.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::StateVariable;
using transform::Status;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::optional<std::size_t> bin_index(const std::vector<double>& edges, double value) {
  if (!(value >= edges.front() && value < edges.back())) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::upper_bound(edges, value) - edges.begin()) - 1;
}

// A sample of one variable of the state, with the number of the bin that contains the sample.
struct VariableSamples {
  StateVariable variable;
  const std::vector<double>& values;
  const std::vector<double>& edges;
  /// Bin of each sample; empty outside all bins, and for a sample at rest in contact with a wall.
  std::vector<std::optional<std::size_t>> bins;

  std::size_t bin_count() const { return edges.size() - 1; }
  double bin_width(std::size_t b) const { return edges[b + 1] - edges[b]; }
};

std::vector<VariableSamples> assign_bins(const StateSamples& samples,
                                         const problem::Problem& problem,
                                         const compare::ComparisonBins& axes) {
  std::vector<VariableSamples> variables{{StateVariable::y, samples.y, axes.y_edges, {}}};
  if (!samples.v.empty()) variables.push_back({StateVariable::ydot, samples.v, axes.v_edges, {}});
  const problem::Walls walls = problem.system.walls();
  const bool may_rest = problem::problem_features(problem).rests_in_contact && !samples.v.empty();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double y = samples.y[k];
    const bool at_rest =
        may_rest && samples.v[k] == 0 && (is_at_wall(walls.left, y) || is_at_wall(walls.right, y));
    for (auto& variable : variables) {
      variable.bins.push_back(at_rest ? std::nullopt
                                      : bin_index(variable.edges, variable.values[k]));
    }
  }
  return variables;
}

// The powers of a variable whose averages are moments of the solution.
constexpr int kPowers[] = {1, 2, 4};
static_assert(2 * std::size(kPowers) == std::size(transform::kMoments));

// Averages over the samples of one variable: the fraction of all samples in each bin, and moments.
struct VariableAverages {
  std::vector<double> fractions, moments;
};

VariableAverages average_samples(const VariableSamples& samples, std::size_t from, std::size_t to) {
  VariableAverages result{std::vector<double>(samples.bin_count()),
                          std::vector<double>(std::size(kPowers))};
  for (std::size_t k = from; k < to; ++k) {
    if (samples.bins[k]) result.fractions[*samples.bins[k]] += 1;
    for (std::size_t p = 0; p < std::size(kPowers); ++p) {
      result.moments[p] += std::pow(samples.values[k], kPowers[p]);
    }
  }
  const double count = static_cast<double>(to - from);
  for (double& fraction : result.fractions) fraction /= count;
  for (double& moment : result.moments) moment /= count;
  return result;
}

struct SamplingErrorsOfVariable {
  std::vector<double> lower, upper;  ///< 95 % confidence limits of the fractions
  std::vector<double> moment_errors;
  L1SamplingError l1;
};

SamplingErrorsOfVariable errors_of_independent_samples(const VariableSamples& samples,
                                                       const VariableAverages& averages,
                                                       double independent) {
  SamplingErrorsOfVariable result;
  std::vector<BinAverageError> errors;
  for (std::size_t b = 0; b < samples.bin_count(); ++b) {
    const double fraction = averages.fractions[b];
    const double error = std::sqrt(fraction * (1 - fraction) / independent);
    result.lower.push_back(std::max(0.0, fraction - numerics::kNormal95 * error));
    result.upper.push_back(fraction + numerics::kNormal95 * error);
    errors.push_back({samples.bin_width(b), b, {error / samples.bin_width(b)}});
  }
  result.l1 = l1_sampling_error(errors);
  for (std::size_t p = 0; p < std::size(kPowers); ++p) {
    double squares = 0;
    for (const double value : samples.values) {
      squares += std::pow(std::pow(value, kPowers[p]) - averages.moments[p], 2);
    }
    result.moment_errors.push_back(
        std::sqrt(squares / static_cast<double>(samples.values.size()) / independent));
  }
  return result;
}

// Blocks of a time series for the bootstrap.
struct BlockDivision {
  std::size_t block_count;
  bool is_reliable;
};

double mean_square(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0) /
         static_cast<double>(values.size());
}

// The sequences whose correlations determine the block length: y, y^2, and the energy of the linear
// oscillator with the same mean squares, which decays most slowly under light damping. The velocity
// itself is the derivative of y and has no slow part.
std::vector<std::vector<double>> slow_sequences(const StateSamples& samples) {
  std::vector<double> squares, energies;
  for (const double y : samples.y) squares.push_back(y * y);
  if (samples.v.empty()) return {samples.y, squares};
  const double y2 = mean_square(samples.y), v2 = mean_square(samples.v);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    energies.push_back(squares[k] / y2 + samples.v[k] * samples.v[k] / v2);
  }
  return {samples.y, squares, energies};
}

// Returns the smallest number of samples after which the autocorrelation of y is at most 0.9.
std::size_t decorrelation_stride(const std::vector<double>& y) {
  constexpr double kAutocorrelation = 0.9;
  const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
  const double variance = mean_square(y) - mean * mean;
  std::size_t stride = 1;
  for (; 10 * stride < y.size(); ++stride) {
    double sum = 0;
    for (std::size_t k = 0; k + stride < y.size(); ++k)
      sum += (y[k] - mean) * (y[k + stride] - mean);
    if (sum <= kAutocorrelation * variance * static_cast<double>(y.size() - stride)) break;
  }
  return stride;
}

// The block length is the longest one of the slow sequences. It is computed from a thinned record:
// the autocovariance of an oscillating sequence vanishes at each quarter period, and with many
// samples per period the rule for the block length would take this for the end of the correlations.
// More than kMaxBlocks blocks only cost time: the standard errors of kMaxBlocks blocks are known to
// 1 / sqrt(2 kMaxBlocks).
BlockDivision divide_into_blocks(const StateSamples& samples) {
  constexpr std::size_t kMaxBlocks = 4096, kMinReliableBlocks = 20, kFewestBlocks = 10;
  const std::size_t stride = decorrelation_stride(samples.y);
  double longest = 1;
  for (const auto& sequence : slow_sequences(samples)) {
    std::vector<double> thinned;
    for (std::size_t k = 0; k < sequence.size(); k += stride) thinned.push_back(sequence[k]);
    const auto length = numerics::bootstrap_block_length(thinned);
    if (!length) return {kFewestBlocks, false};
    longest = std::max(longest, *length * static_cast<double>(stride));
  }
  const auto blocks = static_cast<std::size_t>(static_cast<double>(samples.size()) / longest);
  return {std::clamp(blocks, kFewestBlocks, kMaxBlocks), blocks >= kMinReliableBlocks};
}

// Returns the value that the given fraction of the replicates of one quantity does not exceed.
double replicate_quantile(std::vector<double>& values, double fraction) {
  const auto nth = values.begin() +
                   static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, nth);
  return *nth;
}

SamplingErrorsOfVariable errors_of_time_series(const VariableSamples& samples,
                                               const VariableAverages& averages,
                                               std::size_t block_count) {
  constexpr std::size_t kReplicates = 1000;
  numerics::BlockAverages blocks{samples.bin_count() + std::size(kPowers), {}};
  const std::size_t n = samples.values.size();
  for (std::size_t k = 0; k < block_count; ++k) {
    const VariableAverages block =
        average_samples(samples, k * n / block_count, (k + 1) * n / block_count);
    for (const auto* part : {&block.fractions, &block.moments}) {
      blocks.averages.insert(blocks.averages.end(), part->begin(), part->end());
    }
  }
  const std::vector<double> replicates = numerics::bootstrap_replicates(blocks, kReplicates);
  const auto replicates_of = [&](std::size_t quantity) {
    std::vector<double> values;
    for (std::size_t r = 0; r < kReplicates; ++r) {
      values.push_back(replicates[r * blocks.quantity_count + quantity]);
    }
    return values;
  };
  SamplingErrorsOfVariable result;
  std::vector<double> distances(kReplicates);
  for (std::size_t b = 0; b < samples.bin_count(); ++b) {
    std::vector<double> values = replicates_of(b);
    for (std::size_t r = 0; r < kReplicates; ++r) {
      distances[r] += std::abs(values[r] - averages.fractions[b]);
    }
    result.lower.push_back(replicate_quantile(values, 0.025));
    result.upper.push_back(replicate_quantile(values, 0.975));
  }
  for (const double distance : distances) result.l1.expected += distance / kReplicates;
  result.l1.quantile_99 = replicate_quantile(distances, 0.99);
  for (std::size_t p = 0; p < std::size(kPowers); ++p) {
    double squares = 0;
    for (const double value : replicates_of(samples.bin_count() + p)) {
      squares += std::pow(value - averages.moments[p], 2);
    }
    result.moment_errors.push_back(std::sqrt(squares / kReplicates));
  }
  return result;
}

void add_variable(const VariableSamples& samples, const VariableAverages& averages,
                  const SamplingErrorsOfVariable& errors, Solution& solution) {
  const bool of_y = samples.variable == StateVariable::y;
  transform::Marginal marginal{samples.edges, {}, {}, {}};
  for (std::size_t b = 0; b < samples.bin_count(); ++b) {
    marginal.density.push_back(averages.fractions[b] / samples.bin_width(b));
    marginal.lower.push_back(errors.lower[b] / samples.bin_width(b));
    marginal.upper.push_back(errors.upper[b] / samples.bin_width(b));
  }
  solution.estimated_marginals.emplace_back(samples.variable, std::move(marginal));
  auto& sampling = solution.sampling ? *solution.sampling : solution.sampling.emplace();
  (of_y ? sampling.y : sampling.ydot) = errors.l1.expected;
  (of_y ? sampling.y_99 : sampling.ydot_99) = errors.l1.quantile_99;
  for (std::size_t p = 0; p < std::size(kPowers); ++p) {
    const auto moment = transform::kMoments[p + (of_y ? 0 : std::size(kPowers))].moment;
    solution.moments.*moment = averages.moments[p];
    solution.standard_errors->moments.*moment = errors.moment_errors[p];
  }
}

void add_joint_density(const VariableSamples& y, const VariableSamples& v, Solution& solution) {
  transform::GridDensity grid{y.edges, v.edges, {}};
  grid.averages.assign(grid.y_cell_count() * grid.v_cell_count(), 0.0);
  const double each = 1 / static_cast<double>(y.bins.size());
  for (std::size_t k = 0; k < y.bins.size(); ++k) {
    if (!y.bins[k] || !v.bins[k]) continue;
    const std::size_t i = *y.bins[k], j = *v.bins[k];
    solution.mass += each;
    grid.averages[i * grid.v_cell_count() + j] += each / (y.bin_width(i) * v.bin_width(j));
  }
  solution.density = std::move(grid);
}

Solution samples_solution(const StateSamples& samples, const problem::Problem& problem,
                          const compare::ComparisonBins& axes) {
  Solution solution;
  solution.status = Status::ok;
  solution.energy_residual = kUnknown;
  solution.moments = {kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  solution.standard_errors.emplace();
  solution.standard_errors->energy_residual = kUnknown;
  solution.standard_errors->moments = solution.moments;
  transform::SolverMetricsBuilder metrics;
  metrics.add_diagnostic_metric("samples", transform::value_from_count(samples.size()));
  std::size_t block_count = 0;
  if (samples.is_time_series) {
    const BlockDivision division = divide_into_blocks(samples);
    block_count = division.block_count;
    metrics.add_diagnostic_metric("blocks", transform::value_from_count(block_count));
    if (!division.is_reliable) {
      solution.status = Status::inaccurate;
      solution.reason = fmt::format(
          "the time series of {} samples is too short for its correlations, so that its sampling "
          "errors are unknown; record longer",
          samples.size());
    }
  } else {
    metrics.add_diagnostic_metric("independent", samples.independent);
  }
  const auto variables = assign_bins(samples, problem, axes);
  double fraction_in_bins = 0;
  for (const auto& variable : variables) {
    const VariableAverages averages = average_samples(variable, 0, samples.size());
    fraction_in_bins = std::accumulate(averages.fractions.begin(), averages.fractions.end(), 0.0);
    add_variable(variable, averages,
                 samples.is_time_series
                     ? errors_of_time_series(variable, averages, block_count)
                     : errors_of_independent_samples(variable, averages, samples.independent),
                 solution);
  }
  if (variables.size() == 2) {
    add_joint_density(variables[0], variables[1], solution);
  } else {
    solution.mass = fraction_in_bins;
  }
  add_rest_atom_note(problem, metrics);
  solution.metrics = metrics.take_metrics();
  return solution;
}

void require_valid_samples(const StateSamples& samples, const std::string& label) {
  constexpr std::size_t kMinSamples = 100;
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("samples '{}': {}", label, why));
  };
  const auto &y = samples.y, &v = samples.v;
  if (!v.empty() && y.size() != v.size())
    refuse(fmt::format("{} of y and {} of y' (must be equal)", y.size(), v.size()));
  if (y.size() < kMinSamples)
    refuse(fmt::format("{} samples (must be at least {})", y.size(), kMinSamples));
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!std::isfinite(y[k]) || (!v.empty() && !std::isfinite(v[k]))) {
      refuse(v.empty() ? fmt::format("y = {:.4g} (must be finite)", y[k])
                       : fmt::format("y = {:.4g}, y' = {:.4g} (must be finite)", y[k], v[k]));
    }
  }
  if (!(samples.independent >= 0 && samples.independent <= static_cast<double>(y.size()))) {
    refuse(fmt::format("independent = {:g} (must be 0 .. {}, the number of samples)",
                       samples.independent, y.size()));
  }
}

}  // namespace

Method make_method_from_samples(const ExternalDensity& external, std::string_view method,
                                StateSamples samples) {
  require_valid_samples(samples, external.label);
  if (samples.independent == 0) samples.independent = static_cast<double>(samples.size());
  const auto shared = std::make_shared<const StateSamples>(std::move(samples));
  transform::SolutionIdentity identity = make_external_density_identity(
      external, method, shared->is_time_series ? "given as a time series" : "given as samples");
  identity.plot_style.as_points = true;
  return {.identity = std::move(identity),
          .solve =
              [shared](const problem::Problem& problem, const SolverInputContext& context) {
                return samples_solution(*shared, problem, context.axes);
              },
          .check =
              [shared, label = external.label](const problem::Problem& problem) {
                const problem::Walls walls = problem.system.walls();
                for (const double y : shared->y) {
                  if (is_between_walls(walls, y)) continue;
                  throw InputError(fmt::format("samples '{}': y = {:.4g} (must be {})", label, y,
                                               admissible_range_text(walls)));
                }
              }};
}

}  // namespace fpkcheck::methods
