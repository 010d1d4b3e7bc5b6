#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/options/description.hpp"
#include "problem/model.hpp"
#include "transform/identity.hpp"

namespace fpkcheck::fd_fpk {

using problem::Equation;
using problem::Impact;

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
  characteristics  ///< along the characteristics of the motion, for `kf` with impact `map`
};
inline constexpr base::EnumEntry<TransportScheme> kTransportNames[] = {
    {TransportScheme::upwind, "upwind", "finite volumes of high order"},
    {TransportScheme::characteristics, "characteristics",
     "along the characteristics of the motion"}};
constexpr const auto& enumerator_names(TransportScheme) { return kTransportNames; }
constexpr std::string_view name(TransportScheme transport) { return base::name_of(transport); }

struct Options {
  Equation equation = Equation::kf;
  Impact impact = Impact::map;  ///< map or delta
  StationarySolver stepper = StationarySolver::cvode;
  /// Automatic: transport along characteristics if impulses are rare or losses are strong, see
  /// solve().
  std::optional<TransportScheme> transport{};
  /// Order of the transport terms, 2 .. 8. Schemes of odd order are upwind-biased and cause no
  /// oscillations in the tails. Schemes of even order are centred and cause grid-scale ripples of
  /// about 1e-4 of the peak. Automatic: automatic_order() for the stationary density, kDefaultOrder
  /// for the density over time; see transport_order().
  std::optional<int> order{};
  /// Factor by which the number of cells in each direction exceeds the automatic number: 2 halves
  /// the cell widths.
  double refinement = 1;
  /// Ratio of the cell width far from the origin to the width at the origin; 1 for a uniform grid.
  /// With losses at the impact the density jumps at the origin (by 1/r^2 along the wall). At the
  /// jump a uniform grid converges only with the square of the cell width, whatever the order of
  /// the scheme. Automatic: 16 if the relative jump of the density exceeds a tenth (32 under white
  /// noise), else 1. Under white noise with losses at the impact the ratio applies to the cells of
  /// x2, and the cells of x1 at the wall are graded as the cube of the cells of x2, y ~ v^3 / D2.
  std::optional<double> origin_refinement{};
  std::optional<int> nx{};  ///< number of cells in x1; automatic: by equivalent linearisation
  /// number of cells in x2, even; automatic: from equivalent linearisation
  std::optional<int> nv{};
  /// Upper end of the box in x1; automatic: an x1 at which the density is negligible.
  std::optional<double> x1_max{};
  std::optional<double> x2_max{};  ///< upper end of |x2|; automatic: at a negligible density
  /// Regularisation length of km4: the step l of the fourth difference. The value 0 selects the
  /// literal scheme, in which l is the cell width. Automatic: default_regularisation_length for the
  /// cells of the grid.
  std::optional<double> regularisation_length{};
  /// Threshold of the density on a wall of the box, relative to the peak. An automatic box is
  /// widened if the density on one of its walls exceeds the threshold.
  double wall_density = 1e-6;
  /// Whether an automatic grid that does not resolve its density is refined.
  bool refine_unresolved = true;
  /// Whether the discretisation error is estimated, from two coarser grids. If the options fix
  /// neither transport nor grid, the estimate selects both: see solve().
  bool error_estimate = true;
  /// Largest estimated L1 error of a marginal density with which the status is `ok`.
  double accuracy = 1e-2;
  /// Time limit in seconds. The solver starts a solution on a finer grid only if the solution is
  /// expected to end before the time limit. A solution that exceeds the time limit is aborted, and
  /// the solver returns the most accurate solution so far.
  double max_seconds = 20;
  /// Tolerance that selects the grid: the solver uses the first grid whose error estimate is below
  /// the tolerance. The error estimate comprises the L1 errors of both marginal densities and the
  /// relative errors of the second moments.
  std::optional<double> tolerance{};
  /// Threshold of ||L P||_1 / ||P||_1 below which a density counts as stationary. The unit of the
  /// threshold is the frequency sqrt(k_eq) of equivalent linearisation, so that the threshold does
  /// not depend on the unit of time.
  double residual_tolerance = 1e-10;
};

inline constexpr int kDefaultOrder = 5;
inline int transport_order(const Options& options) { return options.order.value_or(kDefaultOrder); }

/// Names, help texts and ranges of the options, in files and on the command line.
const base::Description<Options>& description();

/// @throws InputError for the first invalid option or invalid combination of options
void validate(const Options& options);

/// The id of the solution that the options define, such as "fd-kf", or "fd-km4-delta" for the
/// impact `delta`.
std::string solution_id(const Options& options);

/// The identity (id, method, equation, impact, role) of the solution that the options define.
transform::SolutionIdentity solution_identity(const Options& options);

/// Returns the options whose solution has the given id, with default values of all options that the
/// id does not contain. The result is empty if no options give a solution with this id.
std::optional<Options> options_of(std::string_view id);

/// Options of the density over time. Times are in the units of the problem.
struct TransientOptions {
  double until = 0;    ///< end time T > 0 of the integration
  int snapshots = 50;  ///< number N of intervals: densities are stored at t = 0, T/N, .. T
  /// Standard deviations of y and y' of the initial Gaussian; automatic: half of the standard
  /// deviations of problem::MotionScales.
  std::optional<double> start_displacement{};
  std::optional<double> start_velocity{};
  /// Means of the initial Gaussian; automatic: mean velocity 0, and mean displacement at the wall
  /// for the paper's oscillator (a Gaussian of z and z'), else at the centre of
  /// problem::MotionScales.
  std::optional<double> start_mean_displacement{};
  std::optional<double> start_mean_velocity{};
  /// Tolerance of the local error of a time step, relative to the largest density.
  double relative_tolerance = 1e-6;
  /// Highest order of BDF, 1 .. 5. BDF of an order above 2 is unstable on part of the imaginary
  /// axis, and the eigenvalues of the rotating oscillator lie next to that axis.
  int max_order = 2;
  /// Function that is called with the completed fraction of the integration time; may be empty.
  std::function<void(double)> progress{};
};

/// Names, help texts and ranges of the options of the density over time, in files and on the
/// command line. All of these options require the option --until.
const base::Description<TransientOptions>& transient_option_descriptions();

/// @throws InputError for the first option that is invalid for a density over time
void validate(const Options& options, const TransientOptions& transient);

}  // namespace fpkcheck::fd_fpk
