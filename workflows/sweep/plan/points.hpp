#pragma once

#include <cstddef>
#include <vector>

#include "base/options/enum_names.hpp"
#include "workflows/sweep/plan/axis.hpp"

namespace fpkcheck::sweep {

/// Design of a plan: how the axes determine its points.
enum class Design {
  product,  ///< Cartesian product of the axes; the last axis varies fastest
  list,     ///< point k has the k-th value of every axis
  sobol     ///< a Sobol sequence in the box of the ranges
};
inline constexpr base::EnumEntry<Design> kDesignNames[] = {
    {Design::product, "product", "every value with every other"},
    {Design::list, "list", "the k-th values of all keys together"},
    {Design::sobol, "sobol", "N points of a Sobol sequence in the box of the ranges"}};
constexpr std::span<const base::EnumEntry<Design>> names(Design) { return kDesignNames; }
constexpr std::string_view name(Design design) { return base::name_of(design); }

inline constexpr std::size_t kMaxPoints = 1'000'000;

/// Points of a plan: for each point the values of all axes, in the order of the axes.
using Points = std::vector<std::vector<base::Value>>;

/// Makes the points of a plan.
/// @param sobol_points number of points for the design sobol; 0 for others
/// @throws InputError with a message of one line, where axes and design are inconsistent or there
///         are too many points
Points make_points(const std::vector<Axis>& axes, Design design, std::size_t sobol_points);

}  // namespace fpkcheck::sweep
