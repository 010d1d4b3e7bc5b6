#pragma once

#include <span>
#include <vector>

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

/// Cells on each side of the middle one that the row of such an excitation may need.
int cells_of_a_row(double length, double width, int points);

/// Whether that rate is more than rounding.
bool grows(const Growth& growth, const problem::ImpulseTrain& impulses);

/// Shortest length l for which -D2 q^2 + D4 (2 sin(q l / 2) / l)^4 <= 0 for all q:
/// l^2 = 4 max_t(sin^4 t / t^2) D4/D2 with D2 = lambda E[Y^2]/2, D4 = lambda E[Y^4]/24.
double shortest_regularisation_length(const problem::ImpulseLaw& law);

/// The widths of a line's cells on which kramers_moyal may grow with this length, increasing; what
/// differs from the one before by less than a twentieth is left out. From the law's default length
/// on these are the cells wider than half of the length, whatever the law: there D4 / (D2 l^2) is
/// at most 5/12, the value of the two-point law, and under that it decays on narrower cells with
/// differences of every order.
std::vector<double> critical_widths(const Line& line, const problem::ImpulseLaw& law,
                                    double length);

/// The shortest length from `from` on, to a thousandth, with which kramers_moyal grows on none of
/// these widths. Where cells are about as wide as the length or wider, differences on them damp
/// short waves less than the derivative does, and the fourth difference interpolates: a length that
/// is long enough for every wave may be too short there.
/// @param points of the centred differences, even
double shortest_regularisation_length(const problem::ImpulseTrain& impulses,
                                      std::span<const double> widths, int points, double from);

/// default_regularisation_length, or as much longer as these cells take: by less than a half from
/// order 3 on where they are up to ten times as wide.
double default_regularisation_length(const problem::ImpulseTrain& impulses, const Line& line,
                                     int points);

}  // namespace fpkcheck::fd_fpk
