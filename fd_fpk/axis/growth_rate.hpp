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
struct FastestGrowingWave {
  double rate;        ///< largest real part of the symbol for 0 < q <= pi/step, per unit time
  double wavenumber;  ///< the wavenumber q of the maximum
};

/// The fastest growing wave, from the symbol of the discrete excitation. The symbol is that of the
/// middle row of the matrix on a uniform axis. The axis must be so long that this row contains no
/// end stencils. A positive rate means that the discrete equation is unstable, with larger growth
/// rates on finer grids: the truncated series acts on exp(i q x2) as -D2 q^2 + D4 q^4, with D4 > 0.
/// @param stencil_size number of cells in a stencil of the centred differences, even
FastestGrowingWave fastest_growing_wave(const Axis& axis, const Excitation& excitation,
                                        int stencil_size);

/// Number of cells on each side of the middle cell to which the middle row of the excitation matrix
/// may extend.
int stencil_half_width_in_cells(double regularisation_length, double cell_width, int stencil_size);

/// Whether the growth rate is positive beyond the level of rounding errors.
bool is_unstable(const FastestGrowingWave& growth, const problem::ImpulseTrain& impulses);

/// Shortest regularisation length l with which -D2 q^2 + D4 (2 sin(q l / 2) / l)^4 <= 0 for all q:
/// l^2 = 4 max_t(sin^4 t / t^2) D4/D2 with D2 = lambda E[Y^2]/2, D4 = lambda E[Y^4]/24.
double shortest_regularisation_length(const problem::ImpulseLaw& law);

/// The cell widths of an axis for which kramers_moyal_excitation may be unstable with this
/// regularisation length l, in increasing order. Widths less than a twentieth above the preceding
/// width are omitted. If l is at least the default length of the law, the critical cells are those
/// wider than l/2, for every law. Reason: for such l, D4 / (D2 l^2) is at most 5/12, the value of
/// the two-point law; up to 5/12 the scheme is stable on cells not wider than l/2, for differences
/// of every order.
std::vector<double> critical_cell_widths(const Axis& axis, const problem::ImpulseLaw& law,
                                         double regularisation_length);

/// The shortest regularisation length, at least `min_length`, with which kramers_moyal_excitation
/// is stable on cells of all given widths, to a relative tolerance of a thousandth. On cells about
/// as wide as the length, or wider, the second difference damps short waves less than the exact
/// derivative does, and the fourth difference interpolates between cells. Then a length for which
/// the continuous symbol is stable may be too short.
/// @param stencil_size number of cells in a stencil of the centred differences, even
double shortest_regularisation_length(const problem::ImpulseTrain& impulses,
                                      std::span<const double> widths, int stencil_size,
                                      double min_length);

/// The default regularisation length on the cells of an axis: default_regularisation_length of the
/// law, or a longer length if stability on these cells requires so. For order 3 and higher, and
/// cells up to ten times as wide as the length, the increase is less than a half.
double default_regularisation_length(const problem::ImpulseTrain& impulses, const Axis& axis,
                                     int stencil_size);

}  // namespace fpkcheck::fd_fpk
