#include "mcs/density_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fpkcheck::mcs {

MarginalEstimate estimate_marginal(const std::vector<StreamRecord>& records, const Plan& plan,
                                   const StreamWeights& weights, transform::Variable variable,
                                   double effective_samples) {
  const bool of_y = variable == transform::Variable::y;
  const auto& edges = (of_y ? plan.y_bins : plan.v_bins).edges();
  std::vector<std::vector<std::uint64_t>> counts;  // with the outer bins, shape (streams, n + 2)
  for (const StreamRecord& record : records) {
    counts.push_back(of_y ? record.histogram.row_counts() : record.histogram.column_counts());
  }
  MarginalEstimate result;
  auto& [marginal, sampling_l1] = result;
  marginal.edges = edges;
  std::vector<double> densities(records.size());
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const double width = marginal.width(b);
    const double unit = 1 / (static_cast<double>(plan.samples_per_stream) * width);
    std::ranges::transform(counts, densities.begin(), [&](const auto& stream_counts) {
      return static_cast<double>(stream_counts[b + 1]) * unit;
    });
    const auto [mean, error] = weights.estimate(densities);
    const double density = std::max(mean, 0.0);  // see estimate_joint_density
    const double half_width = weights.interval_factor() * error;
    marginal.density.push_back(density);
    marginal.lower.push_back(std::max(density - half_width, 0.0));
    // Nothing seen in n independent draws: less than 3/n with 95 % confidence ("rule of three").
    marginal.upper.push_back(error > 0 ? density + half_width : 3 / (effective_samples * width));
    sampling_l1 += std::sqrt(2 / std::numbers::pi) * error * width;
  }
  return result;
}

transform::GridDensity estimate_joint_density(const std::vector<StreamRecord>& records,
                                              const Plan& plan, const StreamWeights& weights) {
  transform::GridDensity density{plan.y_bins.edges(), plan.v_bins.edges(), {}};
  density.averages.resize(density.ny() * density.nv());
  for (std::size_t s = 0; s < records.size(); ++s) {
    const double per_sample = weights[s] / static_cast<double>(plan.samples_per_stream);
    for (std::size_t i = 0; i < density.ny(); ++i) {
      const double per_row = per_sample / (density.y_edges[i + 1] - density.y_edges[i]);
      for (std::size_t j = 0; j < density.nv(); ++j) {
        const double per_cell = per_row / (density.v_edges[j + 1] - density.v_edges[j]);
        density.averages[i * density.nv() + j] +=
            per_cell * static_cast<double>(records[s].histogram.count(i + 1, j + 1));
      }
    }
  }
  // In short runs a cell in the far tails may have been visited by a stream of negative weight
  // only.
  for (double& average : density.averages) average = std::max(average, 0.0);
  return density;
}

}  // namespace fpkcheck::mcs
