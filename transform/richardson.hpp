#pragma once

#include <span>

#include "transform/solution.hpp"

/// Richardson extrapolation from the solutions u_0, u_1, u_2 on the last three grid levels. From
/// each level to the next the cells become narrower by the same ratio q. If the differences of
/// consecutive levels decrease by the ratio
///
///     R = |u_1 - u_0| / |u_2 - u_1|,      of observed order log(R) / log(q),
///
/// then the error of u_2 is |u_2 - u_1| / (R - 1), and u_2 + (u_2 - u_1) / (R - 1) is the
/// Richardson limit. R is computed from sums of the L1 differences of both marginals, since the
/// difference of a single marginal may be small by chance. R is clamped between q (convergence
/// order 1) and q^p, where p is the convergence order of the scheme, so that accidental agreement
/// of two levels does not reduce the error estimate. If the differences decrease faster than the
/// scheme allows, the coarsest grid did not resolve the solution. The ratio R then gives no
/// information on the error of the finest grid (credible_convergence_order()). The result is an
/// estimate, not a bound, since the observed order changes from grid to grid.
namespace fpkcheck::transform {

/// Default ratio of the cell widths of consecutive grid levels.
inline constexpr double kRefinementRatio = 1.4142135623730951;

/// Smallest observed convergence order for which a Richardson limit is computed. For smaller orders
/// there is an error estimate, but no limit.
inline constexpr double kMinOrderForLimit = 1.5;

/// Largest credible excess of the observed convergence order over the order of the scheme. Where
/// errors cancel in the marginals, the excess is up to 1.6 (tests/fd_fpk/convergence_test.cpp).
inline constexpr double kMaxOrderExcess = 1.6;

/// The convergence order to use in an error estimate: the observed order, but at most the order of
/// the scheme. If the observed order exceeds the order of the scheme by kMaxOrderExcess + d, d > 0,
/// the result is the order of the scheme minus d. The result is at least 1.
double credible_convergence_order(double observed, int scheme_order);

/// Whether the observed convergence order is credible enough for a Richardson limit.
bool has_richardson_limit(double observed, int order_of_scheme);

/// The converging quantities of a solution on one grid level: marginals, moments, probabilities of
/// the rest atoms, and impact rate.
struct GridLevel {
  Marginal y;
  Marginal ydot;
  Moments moments;
  std::vector<double> rest_probabilities = {};  ///< listed in the order of Solution::atoms
  double impact_rate = 0;                       ///< 0 if the solver returns none
};
/// The quantities of a solution on its grid level, with marginals over the bins between the edges.
/// @throws std::logic_error if the solution has no density
GridLevel grid_level(const Solution& solution, std::span<const double> y_edges,
                     std::span<const double> ydot_edges);

/// The difference of two consecutive grid levels.
struct LevelDifference {
  double y_l1;      ///< L1 distance of the two p(y), atoms included
  double ydot_l1;   ///< L1 distance of the two p(y'), atoms included
  Moments moments;  ///< finer - coarser
  std::vector<double> rest_probabilities = {};
  double impact_rate = 0;
};
/// The difference of two consecutive grid levels: finer - coarser.
/// @throws std::invalid_argument if the marginals have different bins or the numbers of atoms
/// differ
LevelDifference level_difference(const GridLevel& coarser, const GridLevel& finer);

/// The observed convergence orders log(|u_1 - u_0| / |u_2 - u_1|) / log(q) of different quantities
/// u.
struct ObservedConvergenceOrders {
  double l1;  ///< order of the sum of the L1 differences of both marginals
  double y2;  ///< order of E[y^2]
  double v2;  ///< order of E[y'^2]
};
ObservedConvergenceOrders observed_convergence_orders(const LevelDifference& before,
                                                      const LevelDifference& last, double ratio);

struct RichardsonEstimate {
  ObservedConvergenceOrders orders;
  double reduction_ratio;  ///< clamped ratio R of consecutive differences
  double factor;           ///< 1 / (R - 1): ratio of the error of u_2 to the last difference
  /// Error estimate of u_2 by the credible order. If the difference of a moment changes its sign
  /// between levels, the last difference may be small by chance. The estimate therefore uses the
  /// previous difference divided by R if this number is larger than the last difference.
  ErrorEstimate error;
  std::vector<double> rest_probabilities = {};  ///< error estimates of the rest probabilities
  /// Error estimate of the impact rate. The estimate uses the ratio of the differences of the
  /// impact rate if this ratio is smaller than R. Reason: at a dissipative wall under noise, the
  /// impact rate converges with a power of the width of the narrowest cells.
  double impact_rate = 0;
};
/// Estimates the error of u_2.
/// @param before the difference u_1 - u_0
/// @param last the difference u_2 - u_1; its bins may differ from the bins of `before`
/// @param ratio ratio q > 1 of the cell widths of consecutive levels
/// @param order convergence order of the scheme
RichardsonEstimate richardson_estimate(const LevelDifference& before, const LevelDifference& last,
                                       double ratio, int order);

/// The Richardson limits of moments and of all quantities of a grid level. Averages of the
/// marginals near 0 may become negative.
Moments richardson_limit(const Moments& fine, const LevelDifference& last, double factor);
GridLevel richardson_limit(const GridLevel& middle, const GridLevel& fine, double factor);

}  // namespace fpkcheck::transform
