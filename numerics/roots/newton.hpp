#pragma once

#include <Eigen/Core>
#include <cmath>

namespace fpkcheck::numerics {

struct NewtonOptions {
  double tolerance = 1e-10;  ///< convergence threshold of the norm of the residual
  int max_iterations = 30;
  /// Whether the Newton steps are damped by the factor Equations::step_fraction; otherwise full
  /// Newton steps are taken.
  bool damped = true;
  bool polish =
      true;  ///< whether one more step is taken after convergence, to reach rounding error
};

struct NewtonResult {
  Eigen::VectorXd a;    ///< the root, or the iterate with the smallest residual
  double residual = 0;  ///< norm of the residual at `a`
  int iterations = 0;
  bool converged = false;
};

/// Halves a fraction of the Newton step, beginning with `first_step_fraction`, until `accepts`
/// returns true. Returns the accepted fraction of the Newton step, or 0 if the fraction has fallen
/// to `min_step_fraction`.
template <class Accepts>
double halve_step_until_accepted(double first_step_fraction, double min_step_fraction,
                                 const Accepts& accepts) {
  for (double step_fraction = first_step_fraction; step_fraction > min_step_fraction;
       step_fraction /= 2) {
    if (accepts(step_fraction)) return step_fraction;
  }
  return 0;
}

/// Solves the equations R(a) = 0 by Newton's method. The type `Equations` must have three
/// functions:
///
///     at(a)                 an iterate: `a` and `size`, the norm of R (finite where R exists)
///     step(iterate)         the Newton step at the iterate, with its `change` of a
///     step_fraction(iterate, step)  the fraction of a damped step to take; 0 stops the iteration
template <class Equations>
NewtonResult solve_by_newton(const Equations& equations, const Eigen::VectorXd& start,
                             const NewtonOptions& options) {
  auto here = equations.at(start);
  NewtonResult best{start, here.size, 0, here.size < options.tolerance};
  while (std::isfinite(here.size) && best.iterations < options.max_iterations) {
    const bool polishing = best.converged;
    if (polishing && !options.polish) break;
    const auto step = equations.step(here);
    // After convergence no damping of the Newton step is needed, since only rounding errors remain.
    const double step_fraction =
        polishing || !options.damped ? 1 : equations.step_fraction(here, step);
    if (step_fraction == 0) break;
    const Eigen::VectorXd a = here.a + step_fraction * step.change;
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
