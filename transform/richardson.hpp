#pragma once

#include <span>

#include "transform/solution.hpp"

/// Richardson extrapolation from the last three grid levels u_0, u_1, u_2, whose cells become
/// narrower by the same ratio q. If the differences of consecutive levels decrease by the ratio
///
///     R = |u_1 - u_0| / |u_2 - u_1|,      of observed order log(R) / log(q),
///
/// then the error of u_2 is |u_2 - u_1| / (R - 1), and u_2 + (u_2 - u_1) / (R - 1) is the
/// Richardson limit. R is the ratio of the sums of both L1 differences, since the difference of a
/// single marginal may pass through 0 by chance. R is clamped between the ratios of order 1 and of
/// the scheme's order, so that accidental agreement does not reduce the error estimate. Differences
/// that decrease faster than the scheme allows mean that the coarsest grid did not resolve the
/// solution; the ratio then gives no information on the error of the finest grid
/// (credible_order()). The result is an estimate, not a bound: the observed order changes from grid
/// to grid.
namespace fpkcheck::transform {

/// Default ratio of the cell widths of consecutive grid levels.
inline constexpr double kRefinementRatio = 1.4142135623730951;

/// Least observed order for which a Richardson limit is used. Below it there is an error estimate,
/// but no limit.
inline constexpr double kMinOrderForLimit = 1.5;

/// Largest credible excess of the observed order over the scheme's order: up to 1.6 where errors
/// cancel in the marginals (tests/fd_fpk/convergence_test.cpp).
inline constexpr double kMaxOrderExcess = 1.6;

/// The order to use in an error estimate: the observed order, but at most the scheme's order. If
/// the observed order exceeds the scheme's order by kMaxOrderExcess + d, the result is the scheme's
/// order minus d. The result is at least 1.
double credible_order(double observed, int scheme_order);

/// True if the observed order is credible enough for a Richardson limit.
bool has_limit(double observed, int order_of_scheme);

/// The converging quantities of a solution on one grid level: marginals, moments, probabilities of
/// the rest atoms, and impact rate.
struct GridLevel {
  Marginal y;
  Marginal ydot;
  Moments moments;
  std::vector<double> rest_probabilities = {};  ///< probabilities in the order of Solution::atoms
  double impact_rate = 0;                       ///< 0 if the solver returns none
};
/// @throws std::logic_error when the solution has no density
GridLevel level(const Solution& solution, std::span<const double> y_edges,
                std::span<const double> ydot_edges);

/// The difference of two consecutive grid levels.
struct LevelDifference {
  double y_l1;      ///< L1 distance of the two p(y), atoms included
  double ydot_l1;   ///< L1 distance of the two p(y'), atoms included
  Moments moments;  ///< finer - coarser
  std::vector<double> rest_probabilities = {};
  double impact_rate = 0;
};
/// @throws std::invalid_argument when the marginals have different bins or the numbers of atoms
///         differ
LevelDifference level_difference(const GridLevel& coarser, const GridLevel& finer);

/// log(|u_1 - u_0| / |u_2 - u_1|) / log(q).
struct ObservedOrders {
  double l1;  ///< of the sum of both L1 differences
  double y2;  ///< of E[y^2]
  double v2;  ///< of E[y'^2]
};
ObservedOrders observed_orders(const LevelDifference& before, const LevelDifference& last,
                               double ratio);

struct Richardson {
  ObservedOrders orders;
  double reduction_ratio;  ///< R, clamped
  double factor;           ///< 1 / (R - 1): the remaining error in units of the last difference
  /// Error of u_2, by the credible order. The last difference of a moment may vanish by chance if
  /// it changes sign; the previous difference divided by R replaces it if larger.
  ErrorEstimate error;
  std::vector<double> rest_probabilities = {};  ///< errors of the probabilities of rest, likewise
  /// Error of the impact rate, likewise, but by the ratio of its own differences if this is
  /// smaller: at a wall with losses under noise the rate converges with a power of the narrowest
  /// cells.
  double impact_rate = 0;
};
/// @param before,last u_1 - u_0 and u_2 - u_1; the bins of the two may differ
/// @param ratio q > 1
/// @param order of the scheme
Richardson richardson_estimate(const LevelDifference& before, const LevelDifference& last,
                               double ratio, int order);

/// The Richardson limits; averages near 0 may become negative.
Moments limit(const Moments& fine, const LevelDifference& last, double factor);
GridLevel limit(const GridLevel& middle, const GridLevel& fine, double factor);

}  // namespace fpkcheck::transform
