#pragma once

namespace fpkcheck::exact {

/// The mean time in which x'' = xi, with white noise of intensity 2D, leaves an interval of length
/// L from rest at the distance X L from the lower end:
///
///     T = (L^2 / D)^(1/3) (4/3)^(1/6) / Gamma(7/3) (X (1 - X))^(1/6) (F(X) + F(1 - X)),
///     F(X) = 2F1(1, -1/3; 7/6; X).
///
/// J. Masoliver, J. M. Porra, Phys. Rev. Lett. 75, 189 (1995).
///
/// @param part the position X, 0 < X < 1
/// @param length,diffusion the length L and the constant D, both positive
double random_acceleration_exit_time(double part, double length, double diffusion);

}  // namespace fpkcheck::exact
