#pragma once

#include <cstddef>
#include <vector>

#include "base/options/names.hpp"
#include "workflows/sweep/plan/axis.hpp"

namespace fpkcheck::sweep {

/// How the axes of a plan make its points.
enum class Design {
  product,  ///< every value of each with every value of the others, the last one varying fastest
  list,     ///< the k-th values of all together
  sobol     ///< a Sobol sequence fills the box that the ranges span
};
inline constexpr base::Named<Design> kDesignNames[] = {
    {Design::product, "product", "every value with every other"},
    {Design::list, "list", "the k-th values of all keys together"},
    {Design::sobol, "sobol", "N points of a Sobol sequence in the box of the ranges"}};
constexpr std::span<const base::Named<Design>> names(Design) { return kDesignNames; }
constexpr std::string_view name(Design design) { return base::name_of(design); }

inline constexpr std::size_t kMostPoints = 1'000'000;

/// The points of a plan: for each the values of all axes, in their order.
using Points = std::vector<std::vector<base::Value>>;

/// @param sobol_points of the design sobol; 0 for others
/// @throws InputError on one line where axes and design do not fit, or for too many points
Points points_of(const std::vector<Axis>& axes, Design design, std::size_t sobol_points);

}  // namespace fpkcheck::sweep
