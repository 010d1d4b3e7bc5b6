#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::transform {

enum class StateVariable { y, ydot };
inline constexpr StateVariable kVariables[] = {StateVariable::y, StateVariable::ydot};
inline constexpr base::EnumEntry<StateVariable> kVariableNames[] = {
    {StateVariable::y, "y", "displacement"}, {StateVariable::ydot, "ydot", "velocity"}};
constexpr const auto& enumerator_names(StateVariable) { return kVariableNames; }
constexpr std::string_view name(StateVariable variable) { return base::name_of(variable); }

/// A marginal density given by its averages over bins, the form in which all solutions are
/// compared.
struct Marginal {
  std::vector<double> edges;    ///< n + 1 increasing bin edges
  std::vector<double> density;  ///< n averages of the density over bins
  std::vector<double> lower;    ///< n lower ends of 95 % confidence intervals, or empty
  std::vector<double> upper;    ///< n upper ends of 95 % confidence intervals, or empty

  std::size_t size() const { return density.size(); }
  double bin_centre(std::size_t b) const { return (edges[b] + edges[b + 1]) / 2; }
  double bin_width(std::size_t b) const { return edges[b + 1] - edges[b]; }
};

/// Computes the marginal density of y, paper (30), or of y', paper (34), averaged over the bins
/// between `edges`. For a joint density on cells, ConservativeRemap computes the masses of the
/// bins.
Marginal marginal(const Density& density, StateVariable variable, std::span<const double> edges);

/// Returns the L1 distance int |a - b| of two marginals with the same bins: 0 for equal marginals,
/// 2 for marginals of mass 1 with disjoint supports.
/// @throws std::invalid_argument if the bins of a and b differ
double l1_distance(const Marginal& a, const Marginal& b);

enum class QuadraturePanelSpacing {
  uniform,
  /// Quadrature panels that become narrower towards y = 0 and y' = 0, where strong dissipation and
  /// rare impulses cause a spike of the density.
  graded,
  /// Quadrature panels as for `graded`, with a geometrically subdivided first panel, for densities
  /// that are self-similar near the origin.
  geometric
};

/// Marginal densities at the points of a composite Gauss-Legendre rule on [y_min, y_max] x [-v_max,
/// 0] and [y_min, y_max] x [0, v_max]. The mass and the moments are computed from the values of the
/// marginal densities at the quadrature points.
struct QuadratureMarginals {
  std::vector<double> y;         ///< points of the quadrature rule in y
  std::vector<double> p_y, p_v;  ///< p(y) and p(y') at the quadrature points
  std::vector<double> weight_y, weight_v;
  double mass = 0;
  Moments moments = {};
};

/// Computes the marginal densities of a joint density at quadrature points of a given domain, for
/// example the domain of another density for a comparison. For a density without a wall at y = 0,
/// the quadrature panels in y have equal widths for every value of `panels`.
QuadratureMarginals marginals_at_quadrature_points(
    const SmoothDensity& density, double y_max, double v_max,
    QuadraturePanelSpacing panels = QuadraturePanelSpacing::uniform);

double mean_of_displacement_polynomial(const QuadratureMarginals& marginals,
                                       const numerics::Polynomial& g);

/// Returns the L1 distance of the marginals p(y) plus the L1 distance of the marginals p(y').
/// @pre a and b have the same quadrature points
double summed_l1_distance(const QuadratureMarginals& a, const QuadratureMarginals& b);

}  // namespace fpkcheck::transform
