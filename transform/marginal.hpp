#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {

enum class Variable { y, ydot };
inline constexpr Variable kVariables[] = {Variable::y, Variable::ydot};
/// Names of the variables in tables and files.
inline constexpr base::EnumEntry<Variable> kVariableNames[] = {
    {Variable::y, "y", "displacement"}, {Variable::ydot, "ydot", "velocity"}};
constexpr std::span<const base::EnumEntry<Variable>> enumerator_names(Variable) {
  return kVariableNames;
}
constexpr std::string_view name(Variable variable) { return base::name_of(variable); }

/// A marginal density, given by its averages over bins. Densities on cells, histograms and
/// functions are all compared in this form.
struct Marginal {
  std::vector<double> edges;    ///< n + 1 increasing bin edges
  std::vector<double> density;  ///< n bin averages
  std::vector<double> lower;    ///< n lower ends of 95 % confidence intervals, or empty
  std::vector<double> upper;    ///< n upper ends of 95 % confidence intervals, or empty

  std::size_t size() const { return density.size(); }
  double centre(std::size_t b) const { return (edges[b] + edges[b + 1]) / 2; }
  double width(std::size_t b) const { return edges[b + 1] - edges[b]; }
};

/// The marginal density of y, paper (30), or of y', paper (34), averaged over the bins between
/// `edges`. For a density on cells, ConservativeRemap computes the masses of the bins from the
/// masses of the cells, without interpolation where edges coincide.
Marginal marginal(const Density& density, Variable variable, std::span<const double> edges);

/// The L1 distance int |a - b| of two marginals, as a sum over their common bins: 0 for equal
/// marginals, 2 for marginals of mass 1 with disjoint supports.
/// @throws std::invalid_argument if the bins of a and b differ
double l1(const Marginal& a, const Marginal& b);

}  // namespace fpkcheck::transform
