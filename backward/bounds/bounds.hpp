#pragma once

#include <string>
#include <vector>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/grid.hpp"
#include "backward/bounds/options.hpp"
#include "base/options/names.hpp"
#include "numerics/interval/enclosure.hpp"

namespace fpkcheck::backward {

enum class BoundsStatus {
  ok,             ///< as narrow as asked for
  width_not_met,  ///< guaranteed, but wider than asked for
  failed,         ///< bounds without an end: see the reason
  not_offered     ///< there are no bounds of such a problem: see the reason
};
inline constexpr base::Named<BoundsStatus> kBoundsStatusNames[] = {
    {BoundsStatus::ok, "ok", "guaranteed"},
    {BoundsStatus::width_not_met, "width_not_met", "guaranteed, but wider than asked for"},
    {BoundsStatus::failed, "failed", "not bounded"},
    {BoundsStatus::not_offered, "not_offered", "not offered"}};
constexpr std::span<const base::Named<BoundsStatus>> names(BoundsStatus) {
  return kBoundsStatusNames;
}
constexpr std::string_view name(BoundsStatus status) { return base::name_of(status); }

/// value.lower <= E[functional] <= value.upper, guaranteed.
struct Bound {
  Functional functional;
  numerics::Enclosure value;
};

/// What one grid took.
struct GridRecord {
  Grid grid;
  int unknowns;
  double seconds;                           ///< wall clock
  std::vector<std::size_t> each;            ///< the functionals that were bounded on it, by number
  std::vector<numerics::Enclosure> values;  ///< their bounds on this grid alone
};

struct Bounds {
  BoundsStatus status = BoundsStatus::ok;
  std::string reason;       ///< in one line, empty when ok
  std::vector<Bound> each;  ///< in the order of the options, less w1; none when not offered
  std::vector<GridRecord> grids;
};

/// Guaranteed bounds of stationary expectations of the oscillator with the exact impact under the
/// impulses themselves (equation `kf`, impact `map`), by the backward equation; docs/bounds.md has
/// the theorem and its proof. They hold for the problem whose parameters are the stored doubles.
/// The impacts' momentum w1 is that at the only wall, and left out where there is none or are two.
/// @param problem on its physical axes
/// @throws InputError when the options cannot be used; std::runtime_error when the processor's
/// rounding cannot be set; std::logic_error when bounds of two grids exclude each other
Bounds bounds(const problem::Problem& problem, const Options& options = {});

}  // namespace fpkcheck::backward
