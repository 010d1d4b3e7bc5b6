#pragma once

#include "transform/density.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// What of a solution converges: its marginals, over common bins, and its moments.
struct Marginals {
  transform::Marginal y;
  transform::Marginal ydot;
  transform::Moments moments;
};

/// The moments that are extrapolated, by their names in summary.json.
struct NamedMoment {
  const char* name;
  double transform::Moments::*moment;
};
inline constexpr NamedMoment kRichardsonMoments[] = {{"y1", &transform::Moments::y1},
                                                     {"y2", &transform::Moments::y2},
                                                     {"y4", &transform::Moments::y4},
                                                     {"v2", &transform::Moments::v2},
                                                     {"v4", &transform::Moments::v4}};

/// Orders at which three levels u_0, u_1, u_2 are seen to converge when each is finer by `ratio`:
/// log(|u_1 - u_0| / |u_2 - u_1|) / log(ratio).
struct ObservedOrders {
  double l1;  ///< of both marginals together
  double y2;  ///< of E[y^2]
  double v2;  ///< of E[y'^2]
};
ObservedOrders observed_orders(const Marginals& coarse, const Marginals& middle,
                               const Marginals& fine, double ratio);

/// Order observed below which three levels do not tell what they tend to.
inline constexpr double kLeastOrderOfALimit = 1.5;

/// u_2 + (u_2 - u_1) / (R - 1), with R = |u_1 - u_0| / |u_2 - u_1| from the marginals in L1, kept
/// between that of order 1 and that of the scheme: the error of u_2 is then |u_2 - u_1| / (R - 1).
struct RichardsonLimit {
  Marginals value;
  /// Of the moments of u_2: what was added to them, or what the difference before lets expect
  /// where the last one passes through 0 by chance; in absolute value.
  transform::Moments error;
};
RichardsonLimit richardson_limit(const Marginals& coarse, const Marginals& middle,
                                 const Marginals& fine, double ratio, int order_of_scheme);

}  // namespace fpkcheck::compare
