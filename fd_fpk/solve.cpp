#include "fd_fpk/solve.hpp"

#include <Spectra/Util/Version.h>
#include <fmt/format.h>
#include <klu.h>
#include <sundials/sundials_version.h>

#include <Eigen/Core>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/applicability.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "fd_fpk/stationary/error_estimate.hpp"
#include "fd_fpk/stationary/solve_on_one_grid.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::fd_fpk {

std::vector<std::pair<std::string, std::string>> library_versions() {
  char sundials[32] = "unknown";
  SUNDIALSGetVersion(sundials, sizeof sundials);
  int suitesparse[3] = {};
  SuiteSparse_version(suitesparse);
  return {{"SUNDIALS", sundials},
          {"SuiteSparse", fmt::format("{}.{}.{}", suitesparse[0], suitesparse[1], suitesparse[2])},
          {"KLU", fmt::format("{}.{}.{}", KLU_MAIN_VERSION, KLU_SUB_VERSION, KLU_SUBSUB_VERSION)},
          {"Eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"Spectra", fmt::format("{}.{}.{}", SPECTRA_MAJOR_VERSION, SPECTRA_MINOR_VERSION,
                                  SPECTRA_PATCH_VERSION)}};
}

namespace {

class Solver {
 public:
  Solver(const problem::Problem& problem, const FiniteVolumeOptions& options)
      : problem_(problem),
        scales_(problem::motion_scales(problem)),
        options_(options),
        deadline_(kDeadlineFraction * options.max_seconds) {}

  FiniteVolumeResult solve() const {
    if (!can_use_characteristics(options_) ||
        !characteristics_unsupported_reason(problem_).empty()) {
      return solve_with_transport(TransportScheme::upwind);
    }
    if (has_rest_in_contact(problem_, options_) ||
        options_.transport == TransportScheme::characteristics) {
      return solve_with_transport(TransportScheme::characteristics);
    }
    const double impulses_per_decay_time = problem::impulses_per_decay_time(problem_, scales_);
    const bool along = are_characteristics_preferred(problem_, impulses_per_decay_time);
    if (!has_automatic_grid(options_))
      return solve_with_transport(along ? TransportScheme::characteristics
                                        : TransportScheme::upwind);
    if (along && are_characteristics_required(problem_))
      return solve_with_transport(TransportScheme::characteristics);
    // The transport scheme of first choice and the alternative transport scheme each may use half
    // of the time limit.
    FiniteVolumeResult first =
        solve_with_transport(along ? TransportScheme::characteristics : TransportScheme::upwind,
                             base::Deadline(options_.tolerance ? deadline_.limit_seconds()
                                                               : deadline_.limit_seconds() / 2));
    // If upwind finite volumes are the transport scheme of first choice, their solution is final
    // only if the error estimate is also below kSmallError.
    if (first.solution.has_status_ok() && (along || has_small_error(first))) return first;
    // The alternative transport scheme does not reach the error tolerance faster than the transport
    // scheme of first choice.
    if (options_.tolerance && first.solution.density) return first;
    // Above kMaxImpulsesPerDecayTimeForCharacteristics characteristics would visit too many cells.
    // If the options set the computational box, the box applies to both transport schemes.
    const bool given_box = options_.x1_max || options_.x2_max;
    if (given_box ||
        (!along && impulses_per_decay_time > kMaxImpulsesPerDecayTimeForCharacteristics))
      return first;
    FiniteVolumeResult second = solve_with_transport(
        along ? TransportScheme::upwind : TransportScheme::characteristics, deadline_);
    return is_preferable_result(second, first) ? second : first;
  }

 private:
  static bool has_small_error(const FiniteVolumeResult& result) {
    constexpr double kSmallError = 1e-3;
    const auto& error = result.summary.error;
    return error && error->y_l1 <= kSmallError && error->ydot_l1 <= kSmallError;
  }

  FiniteVolumeResult solve_with_transport(TransportScheme transport) const {
    return solve_with_transport(transport, deadline_);
  }

  FiniteVolumeResult solve_with_transport(TransportScheme transport,
                                          const base::Deadline& deadline) const {
    FiniteVolumeOptions options = options_;
    options.transport = transport;
    // Transport along characteristics has no adjustable order of accuracy.
    if (transport == TransportScheme::upwind) {
      options.order = options.order.value_or(automatic_scheme_order(problem_));
    }
    MotionScalesAndComputationalBox scales_and_box{.scales = scales_};
    // All grids of one solution have the same computational box and length scales for cell widths.
    if (!has_linearised_scales(problem_) && transport == TransportScheme::upwind) {
      options.wall_density *= box_edge_density_factor(problem_);
      scales_and_box.box = stationary_box(problem_, scales_and_box.scales, options, deadline);
    }
    const auto on_one_grid = [&](const FiniteVolumeOptions& grid) {
      return transport == TransportScheme::characteristics
                 ? solve_along_characteristics(problem_, scales_, grid, deadline)
                 : solve_on_one_grid(problem_, scales_and_box, grid, deadline);
    };
    if (options.tolerance) return refine_grid_to_tolerance(on_one_grid, options, deadline);
    if (has_automatic_grid(options)) {
      return refine_grid_until_deadline(on_one_grid, options, deadline,
                                        must_satisfy_balances(problem_)
                                            ? GridRefinementGoal::accurate_and_ok
                                            : GridRefinementGoal::accurate,
                                        scales_and_box.box);
    }
    if (options.error_estimate)
      return solve_with_error_estimate(on_one_grid, options, scales_and_box.box);
    return on_one_grid(options);
  }

  const problem::Problem& problem_;
  const problem::MotionScales scales_;
  const FiniteVolumeOptions& options_;
  // Fraction of the time limit max_seconds until the deadline, since a running solution ends only
  // when the solver next checks the deadline.
  static constexpr double kDeadlineFraction = 0.98;
  base::Deadline deadline_;
};

}  // namespace

FiniteVolumeResult solve_stationary_density(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options) {
  validate(options);
  const base::Stopwatch stopwatch;
  FiniteVolumeResult result = Solver(problem, options).solve();
  auto& [solution, summary] = result;
  solution.seconds = stopwatch.seconds();
  solution.identity = solution_identity(options);
  if (const auto& error = summary.error) {
    solution.error = {error->y_l1, error->ydot_l1, error->moments};
  }
  solution.metrics = solver_metrics(summary);
  return result;
}

}  // namespace fpkcheck::fd_fpk
