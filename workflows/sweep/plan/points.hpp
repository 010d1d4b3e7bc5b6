#pragma once

#include <cstddef>
#include <vector>

#include "base/options/enum_names.hpp"
#include "workflows/sweep/plan/axis.hpp"

namespace fpkcheck::sweep {

/// The design of a plan: the rule by which the axes determine the points.
enum class PlanDesign {
  product,  ///< Cartesian product of the axes; the last axis varies fastest
  list,     ///< point k has the k-th value of every axis
  sobol     ///< a Sobol sequence in the box of the ranges
};
inline constexpr base::EnumEntry<PlanDesign> kPlanDesignNames[] = {
    {PlanDesign::product, "product", "every value with every other"},
    {PlanDesign::list, "list", "the k-th values of all keys together"},
    {PlanDesign::sobol, "sobol", "N points of a Sobol sequence in the box of the ranges"}};
constexpr std::span<const base::EnumEntry<PlanDesign>> enumerator_names(PlanDesign) {
  return kPlanDesignNames;
}
constexpr std::string_view name(PlanDesign design) { return base::name_of(design); }

inline constexpr std::size_t kMaxPoints = 1'000'000;

/// The points of a plan. A point has a value of each axis, in the order of the axes.
using Points = std::vector<std::vector<base::Value>>;

/// Makes the points of a plan from axes and design.
/// @param sobol_points number of points for the design sobol; 0 for other designs
/// @throws InputError with a message of one line if axes and design are inconsistent, or if the
///         plan has more than kMaxPoints points
Points make_points(const std::vector<Axis>& axes, PlanDesign design, std::size_t sobol_points);

}  // namespace fpkcheck::sweep
