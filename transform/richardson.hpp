#pragma once

#include <span>

#include "transform/solution.hpp"

/// Richardson extrapolation from the solutions u_0, u_1, u_2 on the last three grid levels. From
/// each grid level to the next finer level, the cells become narrower by a constant ratio q. If the
/// differences of consecutive grid levels decrease by the ratio
///
///     R = |u_1 - u_0| / |u_2 - u_1|,      of observed order log(R) / log(q),
///
/// then the error of the finest solution u_2 is |u_2 - u_1| / (R - 1), and u_2 + (u_2 - u_1) / (R -
/// 1) is the Richardson limit. The ratio R of consecutive grid differences is computed from sums of
/// the L1 differences of p(y) and p(y'), since the difference of a single marginal density may be
/// small by chance. To prevent that accidental agreement of two grid levels reduces the error
/// estimate, the ratio R is clamped between q (convergence order 1) and q^p, where p is the
/// convergence order of the scheme. If the grid differences decrease faster than the convergence
/// order of the scheme permits, the coarsest grid did not resolve the solution, and the ratio R of
/// grid differences gives no information on the error of the finest grid. The Richardson error
/// estimate is not a bound, since the observed convergence order changes from grid to grid.
namespace fpkcheck::transform {

/// Default ratio of the cell widths of consecutive grid levels.
inline constexpr double kRefinementRatio = 1.4142135623730951;

/// Smallest observed convergence order for which a Richardson limit is computed, in addition to the
/// error estimate.
inline constexpr double kMinOrderForLimit = 1.5;

/// Largest credible excess of the observed convergence order over the convergence order of the
/// scheme. If errors cancel in the marginal densities, the observed order exceeds the order of the
/// scheme by up to 1.6 (tests/fd_fpk/convergence_test.cpp).
inline constexpr double kMaxOrderExcess = 1.6;

/// Returns the convergence order to use in an error estimate: the observed order, but at least 1
/// and at most the order of the scheme. If the observed order exceeds the order of the scheme by
/// kMaxOrderExcess + d, d > 0, the returned order is the order of the scheme minus d.
double credible_convergence_order(double observed, int scheme_order);

/// Returns whether the observed convergence order is credible enough for a Richardson limit.
bool has_richardson_limit(double observed, int scheme_order);

/// Returns the error estimate of a quantity on the finest grid from the last two differences of the
/// quantity. Since the difference between the last two grids may be small by chance, the error
/// estimate is `factor` times the larger of the last difference and the previous difference divided
/// by the reduction ratio R.
/// @param factor ratio of the error to the last difference, about 1 / (R - 1)
double richardson_error_from_differences(double before, double last, double reduction_ratio,
                                         double factor);

/// Returns error estimates of quantities on the finest of three grids, with the factor of safety
/// kErrorSafetyFactor. All quantities get the convergence order that is observed in the sum of the
/// differences of the quantities.
/// @param before,last absolute differences of the quantities between consecutive grids
/// @param scales magnitudes of the quantities; a quantity with an infinite magnitude does not
///   contribute to the observed order
/// @param ratio ratio q > 1 of the cell widths of consecutive grids
/// @pre before, last and scales have the same size
std::vector<double> errors_with_common_order(std::span<const double> before,
                                             std::span<const double> last,
                                             std::span<const double> scales, double ratio,
                                             int scheme_order);

/// The converging quantities of a solution on one grid level: marginal densities, moments,
/// probabilities of the atoms at rest, and impact rate.
struct GridLevelSolution {
  Marginal y;
  Marginal ydot;
  Moments moments;
  /// Probabilities of the atoms at rest, in the order of Solution::atoms.
  std::vector<double> rest_probabilities = {};
  double impact_rate = 0;  ///< impact rate; 0 if the solver returns none
};
/// Returns the converging quantities of a solution, with marginals over the bins between the edges.
/// @throws std::logic_error if the solution has no density
GridLevelSolution make_grid_level(const Solution& solution, std::span<const double> y_edges,
                                  std::span<const double> ydot_edges);

/// The differences of the converging quantities between two consecutive grid levels.
struct GridLevelDifference {
  double y_l1;      ///< L1 distance of p(y) between the two levels, atoms included
  double ydot_l1;   ///< L1 distance of p(y') between the two levels, atoms included
  Moments moments;  ///< moments of the finer level minus moments of the coarser level
  std::vector<double> rest_probabilities = {};
  double impact_rate = 0;
};
/// @throws std::invalid_argument if the marginals have different bins or the numbers of atoms
/// differ
GridLevelDifference grid_level_difference(const GridLevelSolution& coarser,
                                          const GridLevelSolution& finer);

/// The observed convergence orders log(|u_1 - u_0| / |u_2 - u_1|) / log(q) of quantities u on three
/// grid levels with the refinement ratio q.
struct ObservedConvergenceOrders {
  double l1;  ///< observed order of the summed L1 differences of p(y) and p(y')
  double y2;  ///< observed order of E[y^2]
  double v2;  ///< observed order of E[y'^2]
};
ObservedConvergenceOrders observed_convergence_orders(const GridLevelDifference& before,
                                                      const GridLevelDifference& last,
                                                      double ratio);

struct RichardsonEstimate {
  ObservedConvergenceOrders orders;
  double reduction_ratio;  ///< clamped ratio R of the differences of consecutive grid levels
  double factor;           ///< 1 / (R - 1): ratio of the error of u_2 to the last difference
  /// Error estimate of the finest solution u_2 by the credible convergence order. For a moment, the
  /// larger of the last grid difference and the previous grid difference divided by the ratio R
  /// enters the error estimate, since the last grid difference may be small by chance.
  ErrorEstimate error;
  std::vector<double> rest_probabilities = {};  ///< error estimates of the rest probabilities
  /// Error estimate of the impact rate, from the smaller of the reduction ratio R of the densities
  /// and the reduction ratio of the impact rate itself. At a dissipative wall under noise, the
  /// error of the impact rate decreases as a power of the width of the narrowest cells.
  double impact_rate = 0;
};
/// @param before the difference u_1 - u_0
/// @param last the difference u_2 - u_1; the bins of `last` may differ from the bins of `before`
/// @param ratio ratio q > 1 of the cell widths of consecutive levels
/// @param order convergence order of the scheme
RichardsonEstimate richardson_estimate(const GridLevelDifference& before,
                                       const GridLevelDifference& last, double ratio, int order);

/// Returns the Richardson limit of the moments, or of the marginals and moments, from the two
/// finest grid levels. Extrapolated bin averages of a density near 0 may be negative.
Moments richardson_limit(const Moments& fine, const GridLevelDifference& last, double factor);
GridLevelSolution richardson_limit(const GridLevelSolution& middle, const GridLevelSolution& fine,
                                   double factor);

}  // namespace fpkcheck::transform
