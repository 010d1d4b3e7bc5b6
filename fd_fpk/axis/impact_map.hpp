#pragma once

#include "fd_fpk/axis/axis_operators.hpp"
#include "problem/model.hpp"

namespace fpkcheck::fd_fpk {

/// The impact as a map of the probability flux into the wall to the flux off the wall. Particles
/// reach x1 = 0 with speed u and flux f(u) = u p(0, -u). The flux off the wall at speed w is
///
///     map     f(w/r)/r,                          p(0+, w) = p(0-, w/r)/r^2: exact
///     delta   f(w) + (1-r) d(w f)/dw,            its first order in 1-r: paper (12)
///
/// The matrix, shape (cells, cells), maps averages of f over the cells of the speed axis to
/// averages of the flux off the wall. Both forms are computed as differences over a cell of a
/// function of the cumulative flux, so that any interpolation conserves mass. Stencils never cross
/// u = 0, where the density jumps.
///
/// @param speeds axis of the speeds, with faces increasing from 0
/// @param restitution restitution coefficient r, 0 < r <= 1
/// @param impact map or delta
AxisOperator impact_map(const Axis& speeds, double restitution, problem::Impact impact,
                        int scheme_order);

}  // namespace fpkcheck::fd_fpk
