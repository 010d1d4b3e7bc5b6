#pragma once

#include <Eigen/Core>
#include <cmath>

namespace fpkcheck::numerics {

struct NewtonOptions {
  double tolerance = 1e-10;  ///< on the size of the residual
  int max_iterations = 30;
  /// Steps are shortened as the equations ask for; else they are taken whole.
  bool damped = true;
  bool polish = true;  ///< one step more after convergence, which takes the root to rounding
};

/// How an iteration ended; not reaching a root is a result.
struct NewtonResult {
  Eigen::VectorXd a;    ///< the root, or the iterate of the smallest residual
  double residual = 0;  ///< its size
  int iterations = 0;
  bool converged = false;
};

/// The first of `first`, first/2, first/4, .. above `least` that is accepted; 0 when none is.
template <class Accepts>
double halved_until(double first, double least, const Accepts& accepts) {
  for (double share = first; share > least; share /= 2) {
    if (accepts(share)) return share;
  }
  return 0;
}

/// Newton's method for R(a) = 0. The equations say what a residual's size is, and what share of a
/// step brings the root nearer:
///
///     at(a)                 an iterate: `a` and its `size`, finite where there is a residual
///     step(iterate)         Newton's step from there, with its `change` of a
///     share(iterate, step)  of the step to be taken, 0 to give up; asked for when damped
template <class Equations>
NewtonResult newton(const Equations& equations, const Eigen::VectorXd& start,
                    const NewtonOptions& options) {
  auto here = equations.at(start);
  NewtonResult best{start, here.size, 0, here.size < options.tolerance};
  while (std::isfinite(here.size) && best.iterations < options.max_iterations) {
    const bool polishing = best.converged;
    if (polishing && !options.polish) break;
    const auto step = equations.step(here);
    // After convergence rounding alone is left.
    const double share = polishing || !options.damped ? 1 : equations.share(here, step);
    if (share == 0) break;
    const Eigen::VectorXd a = here.a + share * step.change;
    here = equations.at(a);
    if (!std::isfinite(here.size)) break;
    ++best.iterations;
    if (here.size < best.residual) {
      best.a = a;
      best.residual = here.size;
      best.converged = here.size < options.tolerance;
    }
    if (polishing) break;
  }
  return best;
}

}  // namespace fpkcheck::numerics
