#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/options/option_description.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "transform/solution_identity.hpp"

namespace fpkcheck::fd_fpk {

using problem::DensityEquation;
using problem::ImpactCondition;

/// Method that computes the stationary density of the discrete operator.
enum class StationarySolver {
  cvode,  ///< pseudo-transient time steps of CVODE; the result is compared with the null vector
  direct  ///< only the null vector of the operator, by preconditioned GMRES
};
inline constexpr base::EnumEntry<StationarySolver> kStepperNames[] = {
    {StationarySolver::cvode, "cvode", "pseudo-transient steps to stationarity"},
    {StationarySolver::direct, "direct", "null vector of the operator alone"}};
constexpr const auto& enumerator_names(StationarySolver) { return kStepperNames; }
constexpr std::string_view name(StationarySolver stepper) { return base::name_of(stepper); }

/// Discretisation of the transport between two impulses.
enum class TransportScheme {
  upwind,          ///< finite volumes of high order, upwind-biased for odd orders
  characteristics  ///< transport along characteristics of the motion, for `kf` with impact `map`
};
inline constexpr base::EnumEntry<TransportScheme> kTransportNames[] = {
    {TransportScheme::upwind, "upwind", "finite volumes of high order"},
    {TransportScheme::characteristics, "characteristics",
     "along the characteristics of the motion"}};
constexpr const auto& enumerator_names(TransportScheme) { return kTransportNames; }
constexpr std::string_view name(TransportScheme transport) { return base::name_of(transport); }

struct FiniteVolumeOptions {
  DensityEquation equation = DensityEquation::kf;
  /// Impact condition of the equation, either `map` (exact) or `delta` (to first order in 1-r)
  ImpactCondition impact = ImpactCondition::map;
  StationarySolver stepper = StationarySolver::cvode;
  /// Scheme for the transport of the density between impulses. If no transport scheme is set, the
  /// solver chooses transport along characteristics for rare impulses or strong losses, and
  /// otherwise upwind-biased finite volumes.
  std::optional<TransportScheme> transport{};
  /// Order of accuracy of the transport terms, 2 .. 8. Schemes of odd order are upwind-biased and
  /// cause no oscillations in the tails. Schemes of even order are centred and cause grid-scale
  /// ripples of about 1e-4 of the peak density. The automatic order of the transport terms is
  /// automatic_scheme_order() for the stationary density and kDefaultOrder for the density over
  /// time.
  std::optional<int> order{};
  /// Factor by which the number of cells in each direction exceeds the automatic number
  double refinement = 1;
  /// Ratio of the cell width far from the origin to the cell width at the origin; 1 for a uniform
  /// grid. With the restitution coefficient r < 1, the density at the wall jumps by a factor of
  /// 1/r^2 at the velocity 0. Because of the discontinuity at the wall, the error on a uniform grid
  /// decreases only with the square of the cell width. The automatic ratio of cell widths is 16 (32
  /// under white noise) if 1/r^2 - 1, with the restitution coefficient r, exceeds a tenth,
  /// otherwise 1. Under white noise with losses, the cell widths in y at the wall are graded as the
  /// cube of the cell widths in the velocity v, y ~ v^3 / D2 with the noise coefficient D2.
  std::optional<double> origin_refinement{};
  /// Number of grid cells in the displacement x1; by default from the length scales of the density
  std::optional<int> nx{};
  /// Even number of grid cells in the velocity x2; by default from the length scales of the density
  std::optional<int> nv{};
  /// Largest displacement x1 of the computational box; by default with a negligible density.
  std::optional<double> x1_max{};
  std::optional<double> x2_max{};  ///< upper end of |x2|; automatic: an end with negligible density
  /// Regularisation length of the truncated Kramers-Moyal equation `km4`: the step of the fourth
  /// difference. The regularisation length 0 selects the literal scheme, in which the step of the
  /// fourth difference is the cell width. The automatic regularisation length is
  /// default_regularisation_length() for the cells of the grid.
  std::optional<double> regularisation_length{};
  /// Density on an edge of the computational box, relative to the peak density, above which the
  /// solver enlarges an automatic computational box
  double wall_density = 1e-6;
  /// Whether the solver refines an automatic grid that does not resolve the density
  bool refine_unresolved = true;
  /// Whether the solver estimates the discretisation error, from solutions on two coarser grids. If
  /// the options fix neither the transport scheme nor the grid, the solver selects the transport
  /// scheme and the grid by the error estimate.
  bool error_estimate = true;
  /// Largest estimated L1 error of a marginal density for which the status of a solution is `ok`
  double accuracy = 1e-2;
  /// Time limit in seconds. A solution on a finer grid starts only if the solver expects the end of
  /// the solution before the time limit. A solution that exceeds the time limit is aborted, and the
  /// solver returns the most accurate solution so far.
  double max_seconds = 20;
  /// Tolerance on the estimated discretisation error: the solver uses the first grid of a sequence
  /// whose error estimate is below this tolerance. The error estimate comprises the L1 errors of
  /// both marginal densities and the relative errors of the second moments.
  std::optional<double> tolerance{};
  /// Largest accepted stationarity residual ||L P||_1 / ||P||_1 of a density P, with the operator
  /// L, in units of the frequency sqrt(k_eq)
  double residual_tolerance = 1e-10;
};

inline constexpr int kDefaultOrder = 5;
inline int transport_order(const FiniteVolumeOptions& options) {
  return options.order.value_or(kDefaultOrder);
}

/// Returns names, help texts and ranges of the options of the finite-volume solver.
const base::OptionsDescription<FiniteVolumeOptions>& solver_option_descriptions();

/// @throws InputError for the first invalid option or combination of options
void validate(const FiniteVolumeOptions& options);

/// Returns the id of the solution that the options define, such as "fd-kf" or "fd-km4-delta".
std::string solution_id(const FiniteVolumeOptions& options);

transform::SolutionIdentity solution_identity(const FiniteVolumeOptions& options);

/// Returns the options of the solution with the given id, e.g. "fd-kf"; empty for an unknown id.
std::optional<FiniteVolumeOptions> options_of(std::string_view id);

struct CellAveragedDensity;

/// Options for the density over time; all times have the unit of time of the problem.
struct TransientOptions {
  double until = 0;    ///< end time T > 0 of the integration
  int snapshots = 50;  ///< number N of intervals: densities are stored at t = 0, T/N, .. T
  /// Standard deviations of y and y' of the initial Gaussian; by default half of the standard
  /// deviations of problem::MotionScales.
  std::optional<double> start_displacement{};
  std::optional<double> start_velocity{};
  /// Means of displacement and velocity of the initial Gaussian. The default mean velocity of the
  /// initial Gaussian is 0. The default mean displacement of the initial Gaussian is at the wall
  /// for the paper's oscillator, otherwise at the centre of problem::MotionScales.
  std::optional<double> start_mean_displacement{};
  std::optional<double> start_mean_velocity{};
  /// Tolerance of the local error of a time step, relative to the peak density
  double relative_tolerance = 1e-6;
  /// Highest order, 1 .. 5, of the backward differentiation formulas (BDF). BDF of an order above 2
  /// are unstable on part of the imaginary axis, close to the eigenvalues of the oscillator.
  int max_order = 2;
  /// Largest number of cells of an automatic grid for the density over time. With more than 10 000
  /// grid cells the computation of the density over time takes minutes.
  double max_cells = 10000;
  /// Whether the solver computes the periodic state, the density that repeats itself in each period
  /// of the excitation. The search for the periodic state starts from the initial Gaussian.
  bool periodic = false;
  /// Initial density for the search for the periodic state, instead of the initial Gaussian; may be
  /// null
  const CellAveragedDensity* periodic_guess = nullptr;
  /// Whether the integration in time continues after a density that has the status `inadmissible`
  bool continues_if_inadmissible = false;
  /// Function that receives the completed fraction of the integration time; may be empty
  std::function<void(double)> progress{};
};

/// Returns names, help texts and ranges of the options of --until, the density over time.
const base::OptionsDescription<TransientOptions>& transient_option_descriptions();

/// @throws InputError for the first option that is invalid for a density over time
void validate(const FiniteVolumeOptions& options, const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
