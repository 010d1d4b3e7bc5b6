#pragma once

#include <string>
#include <vector>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/options.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "base/options/enum_names.hpp"
#include "numerics/interval/enclosure.hpp"

namespace fpkcheck::backward {

enum class BoundsStatus {
  ok,
  width_not_met,
  failed,      ///< the bounds are infinite; `reason` states the cause
  not_offered  ///< the problem is not supported; `reason` states the cause
};
inline constexpr base::EnumEntry<BoundsStatus> kBoundsStatusNames[] = {
    {BoundsStatus::ok, "ok", "guaranteed"},
    {BoundsStatus::width_not_met, "width_not_met", "guaranteed, but wider than requested"},
    {BoundsStatus::failed, "failed", "not bounded"},
    {BoundsStatus::not_offered, "not_offered", "not supported"}};
constexpr const auto& enumerator_names(BoundsStatus) { return kBoundsStatusNames; }
constexpr std::string_view name(BoundsStatus status) { return base::name_of(status); }

/// Guaranteed bounds value.lower <= E[functional] <= value.upper.
struct FunctionalBounds {
  Functional functional;
  numerics::Enclosure value;
};

/// Computing time of one spline grid, and the bounds computed on the grid.
struct SplineGridBounds {
  SplineGrid grid;
  int unknowns;
  double seconds;                 ///< wall-clock time of the computation
  std::vector<std::size_t> each;  ///< indices of the functionals bounded on the grid
  /// Bounds of the functionals in `each`, computed on the grid without other grids
  std::vector<numerics::Enclosure> values;
};

struct GuaranteedBounds {
  BoundsStatus status = BoundsStatus::ok;
  std::string reason;  ///< cause of a status other than ok, in one line; empty for ok
  /// Bounds in the order of the options; the functional w1 only if supported
  std::vector<FunctionalBounds> each;
  std::vector<SplineGridBounds> grids;
};

/// Returns guaranteed bounds of stationary expectations of the oscillator with the exact impact and
/// impulses (equation `kf`, impact `map`). The bounds follow from the backward equation (theorem
/// and proof: docs/bounds.md). The bounds hold for the problem whose parameters are exactly the
/// stored floating-point numbers. The functional w1 is the impact momentum at the only wall; w1 is
/// omitted without a wall or with two walls.
/// @param problem in physical coordinates
/// @throws InputError when an option is invalid; std::runtime_error when the rounding mode of the
/// processor cannot be set; std::logic_error when bounds from two grids are disjoint
GuaranteedBounds compute_bounds(const problem::Problem& problem, const Options& options = {});

}  // namespace fpkcheck::backward
