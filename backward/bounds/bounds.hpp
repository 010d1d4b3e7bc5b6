#pragma once

#include <string>
#include <vector>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/options.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "base/options/enum_names.hpp"
#include "numerics/interval/enclosure.hpp"

namespace fpkcheck::backward {

/// Outcome of compute_guaranteed_bounds().
enum class BoundsStatus {
  ok,             ///< every interval has the requested half-width, if a half-width is requested
  width_not_met,  ///< guaranteed bounds, but wider than requested; `reason` states the cause
  failed,         ///< a bound is infinite; `reason` states the cause
  not_offered     ///< the problem is not supported; `reason` states the cause
};
inline constexpr base::EnumEntry<BoundsStatus> kBoundsStatusNames[] = {
    {BoundsStatus::ok, "ok", "guaranteed"},
    {BoundsStatus::width_not_met, "width_not_met", "guaranteed, but wider than requested"},
    {BoundsStatus::failed, "failed", "not bounded"},
    {BoundsStatus::not_offered, "not_offered", "not supported"}};
constexpr const auto& enumerator_names(BoundsStatus) { return kBoundsStatusNames; }
constexpr std::string_view name(BoundsStatus status) { return base::name_of(status); }

/// A functional of the stationary density with its guaranteed bounds: the exact value of the
/// functional is between enclosure.lower and enclosure.upper.
struct FunctionalBounds {
  StationaryFunctional functional;
  numerics::Enclosure enclosure;
};

/// Guaranteed bounds that were computed on one spline grid, independently of all other grids.
struct BoundsOnSplineGrid {
  SplineGrid grid;
  int unknown_count;         ///< number of unknown spline coefficients of a certificate
  double computing_seconds;  ///< wall-clock time of the computation on this grid
  /// Indices in GuaranteedBounds::functional_bounds of the functionals bounded on this spline grid
  std::vector<std::size_t> functional_indices;
  /// Guaranteed intervals of the functionals `functional_indices` on this grid, in the same order
  std::vector<numerics::Enclosure> enclosures;
};

/// Bounds of all functionals of a problem. The bounds of a functional in `functional_bounds` are
/// the intersection of its intervals on all spline grids in `grid_bounds`.
struct GuaranteedBounds {
  BoundsStatus status = BoundsStatus::ok;
  std::string reason;  ///< cause of a status other than ok, in one line; empty for ok
  /// Guaranteed bounds of the functionals, in the order of BoundsOptions::functionals. The bounds
  /// of the impact momentum w1 are omitted unless the oscillator has exactly one wall.
  std::vector<FunctionalBounds> functional_bounds;
  std::vector<BoundsOnSplineGrid> grid_bounds;  ///< grids in the order of their computation
};

/// Computes guaranteed bounds of stationary expectations of the oscillator under impulses (equation
/// `kf`), with the exact impact condition (impact `map`). The guaranteed bounds follow from
/// certificates, which are approximate solutions of the backward equation (theorem and proof:
/// docs/bounds.md). The bounds hold for the problem whose parameters are exactly the stored
/// floating-point numbers.
/// @param problem problem in physical coordinates
/// @throws InputError when an option is invalid; std::runtime_error when the rounding mode of the
/// processor cannot be set; std::logic_error when the bounds from two grids are disjoint
GuaranteedBounds compute_guaranteed_bounds(const problem::Problem& problem,
                                           const BoundsOptions& options = {});

}  // namespace fpkcheck::backward
