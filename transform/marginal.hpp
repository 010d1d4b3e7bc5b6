#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {

enum class Variable { y, ydot };
inline constexpr Variable kVariables[] = {Variable::y, Variable::ydot};
/// Names in tables and files.
inline constexpr base::EnumEntry<Variable> kVariableNames[] = {
    {Variable::y, "y", "displacement"}, {Variable::ydot, "ydot", "velocity"}};
constexpr std::span<const base::EnumEntry<Variable>> names(Variable) { return kVariableNames; }
constexpr std::string_view name(Variable variable) { return base::name_of(variable); }

/// A marginal density as averages over bins: the common form in which densities on cells,
/// histograms and functions are compared.
struct Marginal {
  std::vector<double> edges;    ///< n + 1 increasing bin edges
  std::vector<double> density;  ///< n bin averages
  std::vector<double> lower;    ///< n lower ends of 95 % intervals, or empty
  std::vector<double> upper;    ///< n upper ends, or empty

  std::size_t size() const { return density.size(); }
  double centre(std::size_t b) const { return (edges[b] + edges[b + 1]) / 2; }
  double width(std::size_t b) const { return edges[b + 1] - edges[b]; }
};

/// The marginal of y, paper (30), or of y', paper (34), averaged over the bins between `edges`.
/// ConservativeRemap transfers the masses of a grid density; coinciding edges need no
/// interpolation.
Marginal marginal(const Density& density, Variable variable, std::span<const double> edges);

/// int |a - b| as a sum over the common bins: from 0 (equal) to 2 (disjoint, of mass 1 each).
/// @throws std::invalid_argument when the bins differ
double l1(const Marginal& a, const Marginal& b);

}  // namespace fpkcheck::transform
