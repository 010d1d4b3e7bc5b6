#pragma once

namespace fpkcheck::problem {
class ImpulseLaw;
class ImpulseTrain;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

class Line;
struct Excitation;

/// The fastest growing wave exp(i q x2) of an excitation on a velocity line.
struct Growth {
  double rate;        ///< largest real part of the symbol over 0 < q <= pi/step, per unit time
  double wavenumber;  ///< the q at which it is reached
};

/// Scans the symbol of the very matrix that will be used: its middle row, on a uniform line long
/// enough that the row does not feel the ends. A positive rate means that the discrete equation
/// grows, the faster the finer the grid: the truncated series acts on exp(i q x2) as
/// -D2 q^2 + D4 q^4, and D4 > 0.
/// @param points of the centred differences, even
Growth largest_growth(const Line& line, const Excitation& excitation, int points);

/// Whether that rate is more than rounding.
bool grows(const Growth& growth, const problem::ImpulseTrain& impulses);

/// Shortest length l for which -D2 q^2 + D4 (2 sin(q l / 2) / l)^4 <= 0 for all q:
/// l^2 = 4 max_t(sin^4 t / t^2) D4/D2 with D2 = lambda E[Y^2]/2, D4 = lambda E[Y^4]/24.
double shortest_regularisation_length(const problem::ImpulseLaw& law);

}  // namespace fpkcheck::fd_fpk
