#pragma once

#include "fd_fpk/line_operators.hpp"

namespace fpkcheck::fd_fpk {

/// The impact as a map of probability flux. Outgoing particles reach x1 = 0 with speed u and leave
/// with speed r u, so that with the flux f(u) = u p(0, -u), the incoming flux is f(w/r)/r: theory's
/// `map`, p(0+, w) = p(0-, w/r)/r^2.
///
/// The matrix, shape (cells, cells), takes averages of f over cells [b step, (b+1) step] of speed
/// to averages of f(w/r)/r. It interpolates the cumulative flux G(u) = int_0^u f on the faces with
/// degree `order`, never across u = 0 where the density jumps, and takes differences: whatever the
/// interpolation, columns sum to exactly 1 and no mass is lost.
///
/// @param restitution r, 0 < r <= 1
LineOperator impact_map(int cells, double restitution, int order);

}  // namespace fpkcheck::fd_fpk
