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

/// How the stationary density is reached.
enum class Stepper {
  cvode,  ///< pseudo-transient stepping by CVODE, checked against the direct null vector
  direct  ///< the null vector by inverse iteration alone
};
inline constexpr base::Named<Stepper> kStepperNames[] = {
    {Stepper::cvode, "cvode", "stepped to stationarity"},
    {Stepper::direct, "direct", "the null vector alone"}};
constexpr std::span<const base::Named<Stepper>> names(Stepper) { return kStepperNames; }
constexpr std::string_view name(Stepper stepper) { return base::name_of(stepper); }

/// How what is between two impulses is discretised.
enum class Transport {
  upwind,          ///< differences of high order on the cells
  characteristics  ///< along the motion itself, for `kf` and impact `map`
};
inline constexpr base::Named<Transport> kTransportNames[] = {
    {Transport::upwind, "upwind", "differences of high order"},
    {Transport::characteristics, "characteristics", "along the motion itself"}};
constexpr std::span<const base::Named<Transport>> names(Transport) { return kTransportNames; }
constexpr std::string_view name(Transport transport) { return base::name_of(transport); }

struct Options {
  Equation equation = Equation::kf;
  Impact impact = Impact::map;  ///< map or delta
  Stepper stepper = Stepper::cvode;
  /// Automatic: characteristics where impulses are rare or losses strong.
  std::optional<Transport> transport{};
  /// Order of the transport terms, 2 .. 8. Odd orders are upwind-biased and keep the tails clean;
  /// even ones are centred and leave grid-scale ripples of about 1e-4 of the peak. Automatic:
  /// automatic_order() of the stationary density, else kUsualOrder; see order_of().
  std::optional<int> order{};
  /// Cells per automatic cell in each direction: 2 halves the widths.
  double refinement = 1;
  /// How much narrower cells are at the origin than far from it, 1 for a uniform grid. With losses
  /// at the impact the density jumps at the origin, by 1/r^2 along the wall, and a uniform grid of
  /// any order converges there only with the square of its step. Automatic: 16 when the jump is
  /// more than a tenth (32 under white noise), else 1. Under white noise with losses it is that of
  /// x2 alone: cells of x1 are graded as the cube of it, y ~ v^3 / D2.
  std::optional<double> origin_refinement{};
  std::optional<int> nx{};         ///< cells in x1; automatic from equivalent linearisation
  std::optional<int> nv{};         ///< cells in x2, even; automatic likewise
  std::optional<double> x1_max{};  ///< box; automatic: widened until the wall carries no density
  std::optional<double> x2_max{};  ///< box; automatic likewise
  /// Step l of the fourth difference of km4; 0 is the literal scheme. Automatic:
  /// default_regularisation_length on the cells.
  std::optional<double> regularisation_length{};
  /// Density on a wall, relative to the peak, up to which an automatic box is not widened.
  double wall_density = 1e-6;
  /// An automatic grid that does not resolve its density is refined.
  bool refine_unresolved = true;
  /// Adds an estimate of the discretisation error, from two coarser grids. Where the options leave
  /// transport and grid free, both follow from it: see solve().
  bool error_estimate = true;
  /// The largest estimated error of a marginal, in L1, of an `ok`.
  double accuracy = 1e-2;
  /// No finer grid is begun that is expected to end after so long, and one that has not ended by
  /// then is given up: the best answer until then it is.
  double max_seconds = 20;
  /// Picks the grid: the first whose error estimate, L1 of both marginals and the second moments
  /// relative, meets this.
  std::optional<double> tolerance{};
  /// ||L P||_1 / ||P||_1 that counts as stationary, in units of the frequency sqrt(k_eq) of
  /// equivalent linearisation, so that the unit of time does not matter.
  double residual_tolerance = 1e-10;
};

inline constexpr int kUsualOrder = 5;
inline int order_of(const Options& options) { return options.order.value_or(kUsualOrder); }

/// The options as files and the command line name them.
const base::Description<Options>& description();

/// @throws InputError on the first option that cannot be used, or not together with another
void validate(const Options& options);

/// The solution's id: "fd-kf", "fd-km4-delta" where the impact is not `map`.
std::string id(const Options& options);

/// Which solution these options ask for.
transform::Identity identity(const Options& options);

/// The options of which this is the id, all others as by default; nothing when it is of no such
/// solution.
std::optional<Options> options_of(std::string_view id);

}  // namespace fpkcheck::fd_fpk
