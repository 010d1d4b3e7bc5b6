#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/options/description.hpp"
#include "problem/model.hpp"
#include "transform/identity.hpp"

namespace fpkcheck::fd_fpk {

using problem::Equation;
using problem::Impact;

/// How the stationary density is computed.
enum class Stepper {
  cvode,  ///< pseudo-transient steps of CVODE, compared with the null vector
  direct  ///< the null vector of the operator alone, by a preconditioned GMRES solve
};
inline constexpr base::EnumEntry<Stepper> kStepperNames[] = {
    {Stepper::cvode, "cvode", "pseudo-transient steps to stationarity"},
    {Stepper::direct, "direct", "null vector of the operator alone"}};
constexpr std::span<const base::EnumEntry<Stepper>> names(Stepper) { return kStepperNames; }
constexpr std::string_view name(Stepper stepper) { return base::name_of(stepper); }

/// How the transport between two impulses is discretised.
enum class Transport {
  upwind,          ///< finite volumes of high order, upwind-biased for odd orders
  characteristics  ///< along the characteristics of the motion, for `kf` with impact `map`
};
inline constexpr base::EnumEntry<Transport> kTransportNames[] = {
    {Transport::upwind, "upwind", "finite volumes of high order"},
    {Transport::characteristics, "characteristics", "along the characteristics of the motion"}};
constexpr std::span<const base::EnumEntry<Transport>> names(Transport) { return kTransportNames; }
constexpr std::string_view name(Transport transport) { return base::name_of(transport); }

struct Options {
  Equation equation = Equation::kf;
  Impact impact = Impact::map;  ///< map or delta
  Stepper stepper = Stepper::cvode;
  /// Automatic: characteristics where impulses are rare or losses are strong, see solve().
  std::optional<Transport> transport{};
  /// Order of the transport terms, 2 .. 8. Odd orders are upwind-biased and keep the tails free of
  /// oscillations; even orders are centred and leave grid-scale ripples of about 1e-4 of the peak.
  /// Automatic: automatic_order() for the stationary density, else kDefaultOrder; see order_of().
  std::optional<int> order{};
  /// Cells for each automatic cell in each direction: 2 halves the widths.
  double refinement = 1;
  /// Ratio of the cell width far from the origin to the width at the origin; 1 for a uniform grid.
  /// With losses at the impact the density jumps at the origin (by 1/r^2 along the wall). A uniform
  /// grid of any order converges there only with the square of its step. Automatic: 16 when the
  /// jump exceeds a tenth (32 under white noise), else 1. Under white noise with losses the ratio
  /// holds for x2; cells of x1 are graded as the cube of those of x2, y ~ v^3 / D2.
  std::optional<double> origin_refinement{};
  std::optional<int> nx{};  ///< number of cells in x1; automatic: from equivalent linearisation
  std::optional<int> nv{};  ///< number of cells in x2, even; automatic likewise
  /// upper end of the box in x1; automatic: where the density is negligible
  std::optional<double> x1_max{};
  std::optional<double> x2_max{};  ///< upper end of |x2|; automatic likewise
  /// Step l of the fourth difference of km4; 0 is the literal scheme. Automatic:
  /// default_regularisation_length on the cells.
  std::optional<double> regularisation_length{};
  /// Density on a wall of the box, relative to the peak, up to which an automatic box is not
  /// widened.
  double wall_density = 1e-6;
  /// Refine an automatic grid that does not resolve its density.
  bool refine_unresolved = true;
  /// Add an estimate of the discretisation error, from two coarser grids. Where the options fix
  /// neither transport nor grid, the estimate selects both: see solve().
  bool error_estimate = true;
  /// Largest estimated error of a marginal, in L1, for status `ok`.
  double accuracy = 1e-2;
  /// Time limit in seconds. A finer grid starts only if it is expected to end before the limit. A
  /// solve that exceeds the limit is aborted, and the most accurate solution so far is returned.
  double max_seconds = 20;
  /// Selects the grid: the first whose error estimate (L1 of both marginals, and the second moments
  /// relative) is below the tolerance.
  std::optional<double> tolerance{};
  /// Threshold of ||L P||_1 / ||P||_1 below which a density is stationary, in units of the
  /// frequency sqrt(k_eq) of equivalent linearisation: independent of the unit of time.
  double residual_tolerance = 1e-10;
};

inline constexpr int kDefaultOrder = 5;
inline int order_of(const Options& options) { return options.order.value_or(kDefaultOrder); }

/// Names, help texts and ranges of the options, in files and on the command line.
const base::Description<Options>& description();

/// @throws InputError for the first invalid option or invalid combination of options
void validate(const Options& options);

/// The id of the solution: "fd-kf"; "fd-km4-delta" where the impact is not `map`.
std::string id(const Options& options);

/// The identity of the solution of these options.
transform::Identity identity(const Options& options);

/// The options with this id, all others at their defaults; empty when no options have the id.
std::optional<Options> options_of(std::string_view id);

}  // namespace fpkcheck::fd_fpk
