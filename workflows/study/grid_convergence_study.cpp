#include "workflows/study/grid_convergence_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "base/input_error.hpp"
#include "compare/comparison_bins.hpp"
#include "fd_fpk/solve.hpp"
#include "workflows/study/method_variants.hpp"

namespace fpkcheck::study {
namespace {

using transform::GridLevelSolution;
using transform::Solution;

// Largest density on the outer boundary of the grids of a study, relative to the peak. With a
// boundary density of 1e-9 of the peak, the mass outside the grid does not limit the convergence.
constexpr double kWallDensity = 1e-9;

/// Solver of a grid study: all grids and compared methods share the comparison axes, the options
/// and the progress listener.
class GridStudySolver {
 public:
  GridStudySolver(const problem::Problem& problem, const GridStudyOptions& options,
                  std::size_t total, const methods::ProgressListener& listener)
      : problem_(problem),
        axes_(compare::undivided_comparison_bins(compare::comparison_bins(problem))),
        options_(options),
        listener_(listener),
        total_(total) {}

  GridStudyRow grid(int order, int level) {
    GridStudyRow row{
        .order = order,
        .level = level,
        .refinement = options_.coarsest * std::pow(transform::kRefinementRatio, level - 1),
        .solution = {}};
    report_progress(fmt::format("order {}, level {}", order, level), 0, "");
    auto found =
        fd_fpk::solve_stationary_density(problem_, {.equation = options_.equation,
                                                    .impact = options_.impact,
                                                    .stepper = fd_fpk::StationarySolver::direct,
                                                    .order = order,
                                                    .refinement = row.refinement,
                                                    .origin_refinement = options_.origin_refinement,
                                                    .x1_max = y_max_,
                                                    .x2_max = v_max_,
                                                    .wall_density = kWallDensity,
                                                    .refine_unresolved = false,
                                                    .error_estimate = false});
    ++done_;
    row.origin_refinement = found.summary.origin_refinement;
    row.nx = found.summary.nx;
    row.nv = found.summary.nv;
    row.solution = std::move(found.solution);
    row.density = density(row.solution);
    if (row.density) {
      // All grids of a study use one domain, so that the size of the domain does not affect the
      // convergence.
      y_max_ = found.summary.x1_max;
      v_max_ = found.summary.x2_max;
    }
    return row;
  }

  Solution solve(const methods::Method& method) {
    const methods::ProgressCallback progress = [&](double fraction, const std::string& note) {
      report_progress(method.id(), fraction, note);
    };
    progress(0, "");
    Solution solution = methods::solve_with_method(method, problem_, {axes_, progress});
    ++done_;
    return solution;
  }

  std::optional<GridLevelSolution> density(const Solution& solution) const {
    if (!solution.has_density()) return std::nullopt;
    return transform::make_grid_level(solution, axes_.y_edges, axes_.v_edges);
  }

 private:
  void report_progress(const std::string& method, double fraction, const std::string& note) const {
    if (listener_) listener_({done_, total_, problem_.name, method, fraction, note});
  }

  const problem::Problem& problem_;
  compare::ComparisonBins axes_;
  const GridStudyOptions& options_;
  const methods::ProgressListener& listener_;
  std::size_t done_ = 0, total_;
  std::optional<double> y_max_{}, v_max_{};
};

// Returns the reason why three successive grids have no Richardson limit; empty if the limit
// exists.
std::string missing_limit_reason(const GridStudyRow& coarse, const GridStudyRow& middle,
                                 const GridStudyRow& fine) {
  for (const GridStudyRow* grid : {&coarse, &middle, &fine}) {
    if (grid->density && (grid != &fine || fine.solution.has_status_ok())) continue;
    return fmt::format("one of the three finest grids is {} ({})", name(grid->solution.status),
                       grid->solution.reason);
  }
  for (const auto& [before, here] : {std::pair(&coarse, &middle), std::pair(&middle, &fine)}) {
    if (before->nx != here->nx || before->nv != here->nv) continue;
    return fmt::format(
        "two of the three finest levels have the same {} x {} cells, the smallest grid; use a "
        "larger --coarsest",
        here->nx, here->nv);
  }
  if (transform::has_richardson_limit(fine.observed->l1, fine.order)) return "";
  if (fine.observed->l1 > fine.order) {
    return fmt::format(
        "the observed order {:.2g} exceeds what a scheme of order {} explains; use a larger "
        "--coarsest",
        fine.observed->l1, fine.order);
  }
  return fmt::format(
      "the observed order {:.2g} is below {}, the minimum for a limit; refine the origin or use "
      "finer levels",
      fine.observed->l1, transform::kMinOrderForLimit);
}

// Sets the observed orders of convergence in the rows of a grid study, and returns the Richardson
// limit of the grids of one scheme.
RichardsonLimit set_orders_and_richardson_limit(std::vector<GridStudyRow>& grids) {
  for (std::size_t k = 2; k < grids.size(); ++k) {
    const auto &coarse = grids[k - 2].density, &middle = grids[k - 1].density,
               &fine = grids[k].density;
    if (!coarse || !middle || !fine) continue;
    grids[k].observed = transform::observed_convergence_orders(
        transform::grid_level_difference(*coarse, *middle),
        transform::grid_level_difference(*middle, *fine), transform::kRefinementRatio);
  }
  const GridStudyRow &coarse = grids.end()[-3], &middle = grids.end()[-2], &fine = grids.back();
  RichardsonLimit limit{.order = fine.order, .failure = missing_limit_reason(coarse, middle, fine)};
  if (!limit.failure.empty()) return limit;
  const auto found = transform::richardson_estimate(
      transform::grid_level_difference(*coarse.density, *middle.density),
      transform::grid_level_difference(*middle.density, *fine.density), transform::kRefinementRatio,
      fine.order);
  limit.density = transform::richardson_limit(*middle.density, *fine.density, found.factor);
  limit.error = found.error.moments;
  return limit;
}

std::optional<MarginalL1Distances> l1_distance(const std::optional<GridLevelSolution>& one,
                                               const std::optional<GridLevelSolution>& other) {
  if (!one || !other) return std::nullopt;
  return MarginalL1Distances{transform::l1_distance(one->y, other->y),
                             transform::l1_distance(one->ydot, other->ydot)};
}

// Sets the error estimate of the solution on a single grid to the distance from the Richardson
// limit.
void set_error_estimate(GridStudyRow& row) {
  if (row.l1) {
    row.solution.error = transform::ErrorEstimate{.y_l1 = row.l1->y, .ydot_l1 = row.l1->ydot};
  }
  transform::require_error_estimate(row.solution);
}

fd_fpk::FiniteVolumeOptions grid_options(const GridStudyOptions& options) {
  return {.equation = options.equation, .impact = options.impact};
}

}  // namespace

void validate(const GridStudyOptions& options) {
  constexpr int kMinLevels = 3, kMaxLevels = 9;
  if (options.levels < kMinLevels || options.levels > kMaxLevels) {
    throw InputError(
        fmt::format("--levels {} (must be 3 .. 9: an observed order needs 3 levels, and level 9 "
                    "has 256 times the cells of level 1)",
                    options.levels));
  }
  if (options.orders.empty()) {
    throw InputError("--orders: the list is empty; use some of 2 .. 8");
  }
  for (const int order : options.orders) {
    auto of_order = grid_options(options);
    of_order.order = order;
    fd_fpk::validate(of_order);
  }
  fd_fpk::validate(
      {.refinement = options.coarsest, .origin_refinement = options.origin_refinement});
}

GridStudy study_grid(const problem::Problem& problem, const GridStudyOptions& options,
                     const methods::SolverRegistry& registry,
                     const methods::ProgressListener& listener) {
  validate(options);
  const std::set<int> orders(options.orders.begin(), options.orders.end());
  const auto others =
      methods_compared_with_grids(registry, options.equation, options.impact, options.simulation);
  methods::require_compatible_options({problem}, others);
  GridStudySolver solving(problem, options,
                          orders.size() * static_cast<std::size_t>(options.levels) + others.size(),
                          listener);
  GridStudy study{problem, fd_fpk::solution_identity(grid_options(options)), {}, {}, {}};
  for (const int order : orders) {
    std::vector<GridStudyRow> grids;
    for (int level = 1; level <= options.levels; ++level) {
      grids.push_back(solving.grid(order, level));
    }
    study.limits.push_back(set_orders_and_richardson_limit(grids));
    std::ranges::move(grids, std::back_inserter(study.rows));
  }
  const auto& reference_richardson_limit = study.reference_richardson_limit().density;
  for (auto& row : study.rows) {
    row.l1 = l1_distance(row.density, reference_richardson_limit);
    set_error_estimate(row);
  }
  for (auto& one : study.limits) one.l1 = l1_distance(one.density, reference_richardson_limit);
  // Without a Richardson limit the compared methods have no reference.
  if (!reference_richardson_limit) return study;
  if (study.limits.size() > 1) study.limit_accuracy = study.limits.end()[-2].l1;
  for (const auto& method : others) {
    auto solution = solving.solve(method);
    const auto distance = l1_distance(solving.density(solution), reference_richardson_limit);
    transform::require_error_estimate(solution);
    study.others.push_back({std::move(solution), distance});
  }
  return study;
}

bool has_converged(const GridStudy& study) {
  for (std::size_t k = 0; k < study.rows.size(); ++k) {
    const bool finest =
        k + 1 == study.rows.size() || study.rows[k + 1].order != study.rows[k].order;
    const auto status = study.rows[k].solution.status;
    if (finest &&
        (status == transform::Status::failed || status == transform::Status::not_converged)) {
      return false;
    }
  }
  return study.reference_richardson_limit().failure.empty();
}

}  // namespace fpkcheck::study
