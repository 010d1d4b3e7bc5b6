#pragma once

#include <string_view>

#include "base/options/enum_names.hpp"

/// The model that a method solves: a density equation and an impact condition. Each solution states
/// its density equation and impact condition, so that a comparison can distinguish solutions of
/// different models.
namespace fpkcheck::problem {

/// The density equations of the program, which differ in the excitation term.
enum class DensityEquation {
  white,  ///< excitation term -lambda E[Y] p' + D2 p'' with D2 = lambda E[Y^2]/2
  km4,    ///< Kramers-Moyal series truncated after the fourth derivative: paper (16), (20)
  /// Density equation with a well-posed Pade approximant of the Kramers-Moyal series, from the four
  /// coefficients of the truncated series `km4`.
  km4_pade,
  kf  ///< excitation term lambda (E[p(x2 - Y)] - p), the full jump integral
};
inline constexpr base::EnumEntry<DensityEquation> kEquationNames[] = {
    {DensityEquation::white, "white", "white noise"},
    {DensityEquation::km4, "km4", "Kramers-Moyal series to the fourth derivative"},
    {DensityEquation::km4_pade, "km4-pade", "Pade approximant of the Kramers-Moyal series"},
    {DensityEquation::kf, "kf", "full jump integral"}};
constexpr const auto& enumerator_names(DensityEquation) { return kEquationNames; }
constexpr std::string_view name(DensityEquation equation) { return base::name_of(equation); }

enum class ImpactCondition {
  map,  ///< exact impact condition p(0+, w) = p(0-, w/r) / r^2 for w > 0
  /// Impact condition to first order in 1-r, with the restitution coefficient r, paper (12), with
  /// the term (1-r) x2 |x2| delta(x1).
  delta,
  exact  ///< a simulation reflects each trajectory at the impact, paper (2)
};
inline constexpr base::EnumEntry<ImpactCondition> kImpactNames[] = {
    {ImpactCondition::map, "map", "exact"},
    {ImpactCondition::delta, "delta", "to first order in 1-r"},
    {ImpactCondition::exact, "exact", "simulated"}};
constexpr const auto& enumerator_names(ImpactCondition) { return kImpactNames; }
constexpr std::string_view name(ImpactCondition impact) { return base::name_of(impact); }

}  // namespace fpkcheck::problem
