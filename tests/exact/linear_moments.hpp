#pragma once

#include "problem/problem.hpp"

namespace fpkcheck::exact {

/// First and second moments of (z, z').
struct LinearMoments {
  double z;   ///< E[z]
  double v;   ///< E[z']
  double zz;  ///< E[z^2]
  double zv;  ///< E[z z']
  double vv;  ///< E[z'^2]
};

/// Mean and covariance of (z, z').
struct MeanAndCovariance {
  double z = 0, v = 0;  ///< means
  double var_z = 0, cov_zv = 0, var_v = 0;
};

/// The moments at `time` of the linear oscillator (g = k y, f = c y', any c) with an elastic wall
/// at y = 0 or without walls, under impulses with E[Y] = 0 and white noise, from the moments
/// `start` at time 0. With x = (z, z'), A = (0 1; -k -c) and S = E[x x^T],
///
///     dE[x]/dt = A E[x],      dS/dt = A S + S A^T + diag(0, lambda E[Y^2] + 2D),
///     E[x](T) = e^(AT) E[x](0),
///     S(T) = S_inf + e^(AT) (S(0) - S_inf) e^(AT)^T,
///     S_inf = (lambda E[Y^2] + 2D) / (2c) diag(1/k, 1).
///
/// Only the intensity of the law matters. Thus the formulas hold in the (z, z') plane of paper (5),
/// where the amplitudes have the sign of z; without walls z = y.
/// @throws InputError with the parameter for which the formulas do not hold, and for a time that is
///         negative or not finite
LinearMoments linear_moments_at(const problem::Problem& problem, const MeanAndCovariance& start,
                                double time);

/// The moments at `time` of the linear oscillator without walls, under impulses of any law and
/// white noise whose rate and intensity change in time, and a force F(t), by numerical integration
/// of
///
///     dE[x]/dt = A E[x] + (0, b),      b = lambda a(t) E[Y] + F(t),
///     dS/dt = A S + S A^T + (0, b) E[x]^T + E[x] (0, b)^T + diag(0, lambda a(t) E[Y^2] + 2D b(t))
///
/// with a relative error of 1e-10. With F = 0 and E[Y] = 0 the second moments are those of an
/// oscillator with an elastic wall at y = 0, too.
LinearMoments linear_moments_in_time(const problem::Problem& problem,
                                     const MeanAndCovariance& start, double time);

}  // namespace fpkcheck::exact
