#include "methods/own_errors.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "backward/residual/density_residuals.hpp"
#include "base/input_error.hpp"
#include "methods/out_of_memory.hpp"
#include "methods/side_by_side.hpp"
#include "transform/change_of_frame.hpp"

namespace fpkcheck::methods {
namespace {

using results::Case;
using transform::Moments;

/// The results for a solution.
struct Found {
  results::OwnError error;
  std::vector<results::ErrorSource> sources;
};

results::ErrorSource source(const backward::DensityResiduals& residuals,
                            const problem::Frame& frame, const std::string& solution,
                            const transform::NamedMoment& moment,
                            const Eigen::MatrixXd& contributions,
                            const transform::GridDensity& cells) {
  Eigen::MatrixXd values =
      residuals.spread_contributions(contributions, transform::to_x_edges(frame, cells.y_edges),
                                     transform::transform_v_edges(frame, cells.v_edges));
  if (frame.mirrored) values = values.reverse().eval();
  results::ErrorSource result{solution, moment.name, {cells.y_edges, cells.v_edges, {}}};
  for (const auto& row : values.rowwise()) {
    // Files store single precision.
    for (const double value : row) {
      result.density.averages.push_back(static_cast<float>(value));
    }
  }
  return result;
}

/// @param cells of the error sources; null for none
std::optional<Found> own_error(const backward::DensityResiduals& residuals,
                               const problem::Frame& frame, const transform::Solution& solution,
                               const transform::GridDensity* cells) try {
  const auto weighted =
      residuals.estimate_errors(transform::to_wall_coordinates(frame, *solution.density));
  Found found{.error = {solution.id(), weighted.corrected, {}}, .sources = {}};
  for (std::size_t k = 0; k < backward::kMomentCount; ++k) {
    const auto& named = transform::kMoments[k];
    found.error.error.*named.moment =
        solution.moments.*named.moment - weighted.corrected.*named.moment;
    const bool shown = named.moment == &Moments::y2 || named.moment == &Moments::v2;
    if (!shown || cells == nullptr) continue;
    found.sources.push_back(
        source(residuals, frame, solution.id(), named, weighted.contributions[k], *cells));
  }
  return found;
} catch (const InputError&) {
  return std::nullopt;  // the density has no mean
}

}  // namespace

void add_own_errors(Case& one, const ProblemResiduals& of_problem, int threads) {
  std::vector<const transform::Solution*> densities;
  for (const auto& solution : one.solutions) {
    if (solution.density && solution.identity.role != transform::Role::simulation) {
      densities.push_back(&solution);
    }
  }
  if (densities.empty()) return;
  const auto* cells = one.joints.empty() ? nullptr : &one.joints.front().density;
  std::vector<std::optional<Found>> found(densities.size());
  const bool remembered = unless_out_of_memory([&] {
    const auto* residuals = of_problem.get();
    if (residuals == nullptr) return;
    side_by_side(densities.size(), threads, [&](std::size_t k) {
      found[k] = own_error(*residuals, of_problem.frame(), *densities[k], cells);
    });
  });
  if (!remembered) return;
  for (auto& each : found) {
    if (!each) continue;
    one.own_errors.push_back(std::move(each->error));
    std::ranges::move(each->sources, std::back_inserter(one.error_sources));
  }
}

}  // namespace fpkcheck::methods
