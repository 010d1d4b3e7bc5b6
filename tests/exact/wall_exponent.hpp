#pragma once

namespace fpkcheck::exact {

/// The exponent beta by which the density under white noise with losses goes at the wall,
///
///     p(0, -u), p(0, +u) ~ u^-beta   as u -> 0,      r^(beta - 2) = 2 sin((2 beta + 1) pi / 6),
///
/// whatever the spring and the damping: near the origin the noise D2 p_vv and the motion v p_y
/// alone are left, which v -> s v, y -> s^3 y leaves alone. beta = 2 solves it for every r and is not
/// the one; the other root rises from 0 at r = 1 by 1 at r = 1/2 to 2 at r = exp(-pi / sqrt 3),
/// below which impacts accumulate (problem/inelastic_collapse.hpp).
///
/// S. J. Cornell, M. R. Swift, A. J. Bray, Phys. Rev. Lett. 81, 1142 (1998); T. W. Burkhardt,
/// J. Phys. A 33, L429 (2000).
///
/// @param restitution r, exp(-pi / sqrt 3) < r <= 1
/// @throws InputError for any other
double wall_exponent(double restitution);

}  // namespace fpkcheck::exact
