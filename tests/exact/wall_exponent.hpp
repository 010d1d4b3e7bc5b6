#pragma once

namespace fpkcheck::exact {

/// The exponent beta of the density at the wall under white noise, for impacts with losses:
///
///     p(0, -u), p(0, +u) ~ u^-beta   as u -> 0,      r^(beta - 2) = 2 sin((2 beta + 1) pi / 6),
///
/// for every restoring force and damping: near the origin the terms D2 p_vv and v p_y dominate,
/// which are invariant under v -> s v, y -> s^3 y. The root beta = 2 exists for every r and is
/// spurious. The other root increases from 0 at r = 1 over 1 at r = 1/2 to 2 at the collapse
/// restitution r = exp(-pi / sqrt 3), below which impacts accumulate
/// (problem/problem_features.hpp).
///
/// S. J. Cornell, M. R. Swift, A. J. Bray, Phys. Rev. Lett. 81, 1142 (1998); T. W. Burkhardt,
/// J. Phys. A 33, L429 (2000).
///
/// @param restitution restitution coefficient r, exp(-pi / sqrt 3) < r <= 1
/// @throws InputError for other values
double wall_exponent(double restitution);

}  // namespace fpkcheck::exact
