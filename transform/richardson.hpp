#pragma once

#include <span>

#include "transform/solution.hpp"

/// What a sequence of grids tends to, from its last three levels u_0, u_1, u_2, each with cells
/// narrower by the same ratio q. Where the differences of neighbours fall by
///
///     R = |u_1 - u_0| / |u_2 - u_1|,      an observed order of log(R) / log(q),
///
/// the error of u_2 is |u_2 - u_1| / (R - 1), and u_2 + (u_2 - u_1) / (R - 1) the Richardson limit.
/// R comes from the L1 differences of both marginals together (of one alone they may pass through 0
/// by chance), and is kept between that of order 1 and that of the scheme, so that chance agreement
/// is not taken for accuracy. Differences that fall faster than any order of the scheme explains are no
/// sequence of that order: the coarsest grid did not resolve the solution, and its difference says
/// nothing of the error of the finest (credible_order()). It is an estimate and no bound: the order
/// changes from grid to grid.
namespace fpkcheck::transform {

/// Cells of a level are usually this much narrower than those of the one before.
inline constexpr double kLevelRatio = 1.4142135623730951;

/// Order observed below which three levels do not tell what they tend to: there is an estimate of
/// the error then, but no limit.
inline constexpr double kLeastOrderOfALimit = 1.5;

/// What an observed order may be above that of the scheme: where errors of one sign cancel in the
/// marginals it is up to 1.6 (tests/fd_fpk/convergence_test.cpp).
inline constexpr double kMostAboveOrder = 1.6;

/// The order by which an error may be stated where this one is observed: at most that of the scheme,
/// and where more than kMostAboveOrder above it is observed, as much below as that is above, at least
/// 1.
double credible_order(double observed, int of_scheme);

/// Whether differences that fall with the observed order tell what the levels tend to.
bool has_limit(double observed, int order_of_scheme);

/// What of a solution converges: its marginals, its moments, the probabilities of rest, and the rate
/// of impacts.
struct Level {
  Marginal y;
  Marginal ydot;
  Moments moments;
  std::vector<double> at_rest = {};  ///< in the order of Solution::atoms
  double impact_rate = 0;            ///< where its solver states one
};
/// @throws std::logic_error when the solution has no density
Level level(const Solution& solution, std::span<const double> y_edges,
            std::span<const double> ydot_edges);

/// The step from one level to the next.
struct Change {
  double y_l1;      ///< |p(y) - p(y)|, in L1, atoms included
  double ydot_l1;   ///< of p(y')
  Moments moments;  ///< finer - coarser
  std::vector<double> at_rest = {};
  double impact_rate = 0;
};
/// @throws std::invalid_argument when the marginals are on different bins, or there are not as many
///         atoms
Change change(const Level& coarser, const Level& finer);

/// log(|u_1 - u_0| / |u_2 - u_1|) / log(q).
struct ObservedOrders {
  double l1;  ///< of both marginals together
  double y2;  ///< of E[y^2]
  double v2;  ///< of E[y'^2]
};
ObservedOrders observed_orders(const Change& before, const Change& last, double ratio);

struct Richardson {
  ObservedOrders orders;
  double fall;    ///< R, as kept between its bounds
  double factor;  ///< 1 / (R - 1): of the last difference that is still missing
  /// Of u_2, by the credible order. A moment's last difference may vanish by chance where it changes
  /// its sign: the one before bounds it.
  StatedError error;
  std::vector<double> at_rest = {};  ///< errors of these probabilities, likewise
  /// Likewise, by the fall of its own differences where they fall more slowly: at a wall with losses
  /// under noise the rate converges with a power of the narrowest cells.
  double impact_rate = 0;
};
/// @param before,last u_1 - u_0 and u_2 - u_1, each on bins of its own
/// @param ratio q > 1
/// @param order of the scheme
Richardson richardson(const Change& before, const Change& last, double ratio, int order);

/// The Richardson limits; averages near 0 may come out negative.
Moments limit(const Moments& fine, const Change& last, double factor);
Level limit(const Level& middle, const Level& fine, double factor);

}  // namespace fpkcheck::transform
