#include "fd_fpk/selection_policy.hpp"

#include <algorithm>
#include <cmath>

#include "fd_fpk/characteristics/rest_points.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Returns the mean acceleration towards the wall by impulses of nonzero mean, relative to the
// acceleration of the spring at one standard deviation. If the mean acceleration by impulses
// exceeds the acceleration of the spring, the oscillator makes short flights between impacts
// instead of half-cycles.
double mean_force_ratio(const problem::Problem& problem) {
  const auto linear = problem::equivalent_linearisation(problem);
  return -problem.impulses.rate_times_moment(1) /
         problem.system.restoring_force()(linear.displacement_deviation);
}

bool has_short_flights(const problem::Problem& problem) {
  constexpr double kBouncing = 1, kLosses = 0.7;
  return mean_force_ratio(problem) > kBouncing && problem.system.restitution() < kLosses;
}

// Returns whether impacts are rare, since impulses of nonzero mean keep the oscillator off the
// wall.
bool has_rare_impacts_by_mean_impulse(const problem::Problem& problem) {
  constexpr double kDeviations = 4;
  return problem::static_deflection(problem) >
         kDeviations * problem::equivalent_linearisation(problem).displacement_deviation;
}

bool has_dissipative_wall(const problem::System& system) {
  return has_dissipative_impacts(system.left_wall()) ||
         has_dissipative_impacts(system.right_wall());
}

// Returns whether the widths of the cells of x1 may be graded as the cube of the widths of the
// cells of x2. Finite-volume schemes of even orders and of order 7 oscillate on cells in x1 that
// are graded as the cube of the cells in x2.
bool can_grade_cubically(const FiniteVolumeOptions& options) {
  return transport_order(options) == 3 || transport_order(options) == 5;
}

// Returns whether impulses are so small that the density at a wall has the singularity of white
// noise down to the resolved lengths. Impulses count as small if their amplitude is below an eighth
// of the standard deviation of velocity. The threshold of one eighth was set by error estimates and
// limits of fine grids for case 1 with r = 0.3 .. 0.7, impulse rates 30 .. 1e6, and Gaussian and
// exponential impulses (build/release/benchmarks/fpkcheck_rates --restitutions 0.3,0.5,0.7 --rates
// 30,100,1e3,1e4,1e6).
bool are_impulses_small(const problem::Problem& problem) {
  constexpr double kShort = 1.0 / 8;
  if (!problem.impulses.is_acting()) return false;
  return std::sqrt(problem.impulses.amplitude_law().moment(2)) <
         kShort * problem::motion_scales(problem).velocity_deviation;
}

// Returns the coefficient of p'' in the excitation terms that act on the shortest resolved lengths:
// white noise, the truncated Kramers-Moyal series, and small impulses.
double diffusion_coefficient(const problem::Problem& problem, DensityEquation equation) {
  const bool local = equation == DensityEquation::km4 || equation == DensityEquation::white ||
                     are_impulses_small(problem);
  return problem.noise.diffusion() + (local ? problem.impulses.rate_times_moment(2) / 2 : 0);
}

// Returns whether the density at a wall with losses has the singularity u^-beta
// (exact::wall_exponent) at the speed u = 0, towards which cells are graded. The singularity
// u^-beta of the density occurs under white noise and under impulses that act as white noise. For
// problems without has_linearised_scales() the singularity also occurs for the truncated
// Kramers-Moyal equation `km4`.
bool has_wall_singularity(const problem::Problem& problem, const FiniteVolumeOptions& options) {
  if (!has_linearised_scales(problem)) {
    return diffusion_coefficient(problem, options.equation) > 0;
  }
  return options.impact == ImpactCondition::map && problem.system.restitution() < 1 &&
         can_grade_cubically(options) &&
         (options.equation == DensityEquation::white || are_impulses_small(problem));
}

double automatic_origin_refinement(const problem::Problem& problem,
                                   const FiniteVolumeOptions& options) {
  if (!has_dissipative_wall(problem.system)) {
    return problem.system.has_force_jumps_in_v() ? kForceJumpRefinement : 1;
  }
  const bool singular = has_wall_singularity(problem, options);
  // Schemes of high order oscillate on narrow cells at the spike of the density that rare impulses
  // cause. A wide cell represents the spike of the density as a mass. Under white noise the
  // stationary density has no spike.
  if (!singular && is_density_unbounded_at_origin(problem)) return 1;
  if (has_linearised_scales(problem) && has_rare_impacts_by_mean_impulse(problem)) return 1;
  return singular ? kOriginRefinementUnderWhiteNoise : kOriginRefinement;
}

}  // namespace

bool has_linearised_scales(const problem::Problem& problem) {
  return problem::has_equivalent_linearisation(problem);
}

bool must_satisfy_balances(const problem::Problem& problem) {
  return !has_linearised_scales(problem);
}

// The thresholds of the choice between characteristics and upwind differences are empirical, from
// random problems (docs/limits.md).
bool are_characteristics_preferred(const problem::Problem& problem,
                                   double impulses_per_decay_time) {
  constexpr double kRare = 3, kFrequent = 500;  // limits of the number of impulses per decay time
  constexpr double kStrongLosses = 0.4;
  constexpr double kMaxDeflection = 2;
  if (impulses_per_decay_time < kRare) return true;
  if (!has_linearised_scales(problem)) {
    return contraction_rate_of_attractors(DeterministicFlow(problem.system)) >
           problem.impulses.arrival_rate();
  }
  const auto linear = problem::equivalent_linearisation(problem);
  const bool losses =
      problem.system.restitution() < kStrongLosses &&
      problem::static_deflection(problem) < kMaxDeflection * linear.displacement_deviation;
  return (losses && impulses_per_decay_time < kFrequent) || has_short_flights(problem);
}

bool are_characteristics_required(const problem::Problem& problem) {
  constexpr double kStronglyBouncing = 5;
  // Without a rest point the density is concentrated around a limit cycle.
  if (!has_linearised_scales(problem))
    return find_rest_points(DeterministicFlow(problem.system)).empty();
  return is_density_unbounded_at_origin(problem) ||
         (has_short_flights(problem) && mean_force_ratio(problem) > kStronglyBouncing);
}

int automatic_scheme_order(const problem::Problem& problem) {
  return has_dissipative_wall(problem.system) || has_linearised_scales(problem)
             ? kDefaultOrder
             : kHighFiniteVolumeOrder;
}

// A computational box with the default FiniteVolumeOptions::wall_density truncates the tails of the
// density under impulses. The truncated tails contribute a fraction 2e-7 of E[v^2], and a fraction
// 2e-5 of the part of E[v^4] due to the fourth cumulant. For problems with has_linearised_scales(),
// a solution in an enlarged computational box estimates the truncation error.
double box_edge_density_factor(const problem::Problem& problem) {
  constexpr double kTails = 1e-2, kTailsOfImpulses = 2e-3;
  return problem.impulses.is_acting() ? kTailsOfImpulses : kTails;
}

bool has_automatic_grid(const FiniteVolumeOptions& options) {
  const FiniteVolumeOptions defaults;
  return options.error_estimate && options.refine_unresolved && !options.nx && !options.nv &&
         options.refinement == defaults.refinement;
}

// If the smallest density is below kLimit, ten times the limit of the status `ok`
// (kStationaryResolutionLimits), no finer grid would give the status `ok`: in case 1 with r = 0.3
// .. 0.9 and impulse rates 0.3 .. 30 the smallest density changes by less than a factor of 2
// between grids whose cell widths differ by a factor of 4 (`fpkcheck fd case1 --equation km4
// --impact delta --set system.restitution=R --set impulse.rate=LAMBDA --refinement F`, F = 0.35 ..
// 1.5).
bool has_negative_density_on_all_grids(const FiniteVolumeOptions& options, double min_density) {
  constexpr double kLimit = -1e-3;
  return options.impact == ImpactCondition::delta && min_density < kLimit;
}

bool is_density_unbounded_at_origin(const problem::Problem& problem) {
  return has_linearised_scales(problem) && problem::impulses_per_decay_time(problem) <= 2;
}

bool has_dissipative_impacts(const std::optional<problem::Wall>& wall) {
  constexpr double kSmallJump = 0.1;
  return wall && (!wall->has_constant_restitution() ||
                  1 / (wall->restitution * wall->restitution) - 1 > kSmallJump);
}

double effective_origin_refinement(const problem::Problem& problem,
                                   const FiniteVolumeOptions& options) {
  return options.origin_refinement.value_or(automatic_origin_refinement(problem, options));
}

// Under white noise with losses, the density near the origin is v^-beta times a function of D2 y /
// v^3 (Cornell, Swift, Bray 1998). The force has no effect on the density near the origin, since
// noise dominates slow motion at the wall. If the cells resolve the velocity x2 down to the length
// `core`, they must resolve the displacement x1 down to core^3 / D2. If the cells of x1 are graded
// like the cells of x2, the computed impact rate is too small (by 1 % at the restitution
// coefficient 0.6). If the widths of neighbouring cells differ by more than a quarter, a grid-scale
// ripple of up to 4 % of p(y) is amplified. The length kLongReach keeps the relative differences of
// neighbouring cell widths below a quarter, also on the coarser grids of an error estimate.
GridCellGradings automatic_gradings(const problem::Problem& problem,
                                    const FiniteVolumeOptions& options,
                                    const DensityLengthScales& lengths) {
  // Distances from a refinement point, in length scales of the density, at which the cells have
  // half of the width of cells far from the point.
  constexpr double kLongReach = 2, kReach = 0.75;
  const double factor = effective_origin_refinement(problem, options);
  if (factor == 1) return {};
  const bool linearised = has_linearised_scales(problem);
  const double diffusion = diffusion_coefficient(problem, options.equation);
  const bool cubic = has_wall_singularity(problem, options) && can_grade_cubically(options);
  const auto grading = [factor](double reach) {
    return CellGrading{.reach = reach, .core = reach / (factor - 1)};
  };
  const double reach = linearised ? kReach : kLongReach;
  GridCellGradings result{
      .x1 = grading((cubic ? kLongReach : reach) * lengths.x1),
      .x2 = grading(reach * lengths.x2),
      .at_left_wall = linearised || has_dissipative_impacts(problem.system.left_wall()),
      .at_right_wall = has_dissipative_impacts(problem.system.right_wall())};
  if (cubic) result.x1.core = std::min(result.x1.core, std::pow(result.x2.core, 3) / diffusion);
  return result;
}

DensityLengthScales automatic_cell_widths(const problem::Problem& problem,
                                          const FiniteVolumeOptions& options,
                                          const DensityLengthScales& lengths) {
  // Cell widths of automatic grids, in length scales of the density. The steep tail of p(y)
  // requires narrower cells in the displacement x1 than in the velocity x2.
  constexpr double kX1Step = 0.15, kX2Step = 0.16;
  // Wide cells far from the refinement points limit the total number of cells, in spite of many
  // narrow cells near the refinement points.
  constexpr double kGradedWidth = 1.6;
  double factor =
      (effective_origin_refinement(problem, options) == 1 ? 1 : kGradedWidth) / options.refinement;
  if (transport_order(options) == kHighFiniteVolumeOrder) factor *= kCellWidthFactorOfHighOrder;
  return {factor * kX1Step * lengths.x1, factor * kX2Step * lengths.x2};
}

}  // namespace fpkcheck::fd_fpk
