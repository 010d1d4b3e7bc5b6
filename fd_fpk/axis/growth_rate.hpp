#pragma once

#include <span>
#include <vector>

namespace fpkcheck::problem {
class ImpulseLaw;
class ImpulseTrain;
}  // namespace fpkcheck::problem

namespace fpkcheck::fd_fpk {

class Axis;
struct Excitation;

/// The fastest growing wave exp(i q x2) of an excitation on a velocity axis.
struct Growth {
  double rate;        ///< largest real part of the symbol for 0 < q <= pi/step, per unit time
  double wavenumber;  ///< the q of that maximum
};

/// Maximum growth rate from the symbol of the discrete excitation. The symbol is that of the middle
/// row of the matrix on a uniform axis, long enough that the row contains no end stencils. A
/// positive rate means that the discrete equation is unstable, and increasingly so on finer grids:
/// the truncated series acts on exp(i q x2) as -D2 q^2 + D4 q^4, with D4 > 0.
/// @param points stencil length of the centred differences, even
Growth largest_growth(const Axis& axis, const Excitation& excitation, int points);

/// Number of cells on each side of the middle cell that the row of such an excitation may need.
int stencil_half_width(double length, double width, int points);

/// True if the growth rate exceeds rounding errors.
bool is_unstable(const Growth& growth, const problem::ImpulseTrain& impulses);

/// Shortest length l for which -D2 q^2 + D4 (2 sin(q l / 2) / l)^4 <= 0 for all q: l^2 = 4
/// max_t(sin^4 t / t^2) D4/D2 with D2 = lambda E[Y^2]/2, D4 = lambda E[Y^4]/24.
double shortest_regularisation_length(const problem::ImpulseLaw& law);

/// The cell widths of an axis for which kramers_moyal may be unstable with this length, increasing;
/// widths less than a twentieth above the preceding width are omitted. For lengths from the default
/// length of the law upwards these are the cells wider than half of the length, for every law:
/// there D4 / (D2 l^2) is at most 5/12, the value of the two-point law, and below 5/12 the scheme
/// is stable on narrower cells for differences of every order.
std::vector<double> critical_widths(const Axis& axis, const problem::ImpulseLaw& law,
                                    double length);

/// The shortest length not below `from`, with a tolerance of a thousandth, for which kramers_moyal
/// is stable on all these widths. Where cells are about as wide as the length or wider, their
/// second difference damps short waves less than the exact derivative, and the fourth difference
/// interpolates. A length that stabilises the continuous symbol may then be too short.
/// @param points stencil length of the centred differences, even
double shortest_regularisation_length(const problem::ImpulseTrain& impulses,
                                      std::span<const double> widths, int points, double from);

/// default_regularisation_length of the law, or a longer length where these cells require one:
/// longer by less than a half from order 3 upwards, for cells up to ten times as wide as the
/// length.
double default_regularisation_length(const problem::ImpulseTrain& impulses, const Axis& axis,
                                     int points);

}  // namespace fpkcheck::fd_fpk
