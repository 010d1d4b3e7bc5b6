#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "transform/density.hpp"

namespace fpkcheck::transform {

enum class Variable { y, ydot };
inline constexpr Variable kVariables[] = {Variable::y, Variable::ydot};
/// Names of the variables in tables and files.
inline constexpr base::EnumEntry<Variable> kVariableNames[] = {
    {Variable::y, "y", "displacement"}, {Variable::ydot, "ydot", "velocity"}};
constexpr const auto& enumerator_names(Variable) { return kVariableNames; }
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

/// Rule for the widths of the panels of the quadrature rule.
enum class PanelSpacing {
  uniform,
  /// Narrower towards 0, where strong dissipation and rare impulses cause a spike of the density.
  graded,
  /// Like `graded`, but the first panel is subdivided geometrically, for densities that are
  /// self-similar near the origin.
  geometric
};

/// Marginal densities at the points of a composite Gauss-Legendre rule on [y_min, y_max] x [-v_max,
/// 0] and [y_min, y_max] x [0, v_max]. Mass and moments are computed from the same values of the
/// density.
struct PanelMarginals {
  std::vector<double> y;         ///< points of the quadrature rule in y
  std::vector<double> p_y, p_v;  ///< p(y) and p(y') at the quadrature points
  std::vector<double> weight_y, weight_v;
  double mass = 0;
  Moments moments = {};
};

/// Marginals of a density, computed on a given domain. For a comparison of two densities the domain
/// may be that of the other density. `panels` applies to a density with a wall at y = 0; for
/// another y_min, the panels of y have equal widths.
PanelMarginals panel_marginals(const SmoothDensity& density, double y_max, double v_max,
                               PanelSpacing panels = PanelSpacing::uniform);

/// The expectation E[g(y)] of a polynomial g of the displacement.
double mean_of_displacement_polynomial(const PanelMarginals& marginals,
                                       const numerics::Polynomial& g);

/// The distance of two densities: the L1 distance of the marginals p(y) plus the L1 distance of the
/// marginals p(y').
/// @pre a and b have the same quadrature points
double distance(const PanelMarginals& a, const PanelMarginals& b);

}  // namespace fpkcheck::transform
