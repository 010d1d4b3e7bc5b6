#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fd_fpk/axis/axis_operators.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
class ImpulseTrain;
}  // namespace fpkcheck::problem
namespace fpkcheck::fd_fpk {

/// The excitation terms of the density equation on a velocity axis: the coefficients of drift and
/// diffusion, which finite differences discretise, and a matrix for the nonlocal exchange of mass
/// between cells.
struct Excitation {
  double drift = 0;      ///< drift coefficient a in the term -a p'
  double diffusion = 0;  ///< diffusion coefficient D in the term D p''
  /// Matrix of the velocity jumps, or of the third and fourth differences, shape (cells, cells);
  /// empty if the equation has no jumps and no such differences. The exchange matrix conserves
  /// mass: the row vector of cell widths times the matrix is zero.
  Eigen::MatrixXd exchange;
  /// Coefficients of a drift and a diffusion that approximate the exchange matrix in the
  /// preconditioner. exchange_drift and exchange_diffusion hold for long waves; exchange_rate is
  /// the rate at which the exchange makes short waves decay. exchange_drift, exchange_diffusion and
  /// exchange_rate are zero if `drift` and `diffusion` suffice for the preconditioner.
  double exchange_drift = 0;
  double exchange_diffusion = 0;
  double exchange_rate = 0;
};

/// Parameter-free regularisation length of `km4`: l^2 = E[Y^6] / (5 E[Y^4]). With this length l the
/// leading error of the fourth difference equals the sixth term of the Kramers-Moyal series. The
/// default regularisation length makes the scheme well-posed, since E[Y^6]/E[Y^4] >= E[Y^4]/E[Y^2]
/// (Cauchy-Schwarz). For Gaussian amplitudes Y of mean zero, l is the standard deviation of Y.
double default_regularisation_length(const problem::ImpulseLaw& law);

/// The white-noise approximation of the impulses: -lambda E[Y] p' + lambda E[Y^2]/2 p''.
Excitation white_noise_excitation(const problem::ImpulseTrain& impulses);

/// The Kramers-Moyal series truncated after the fourth derivative: the terms of
/// white_noise_excitation and two differences of the fixed step l, whatever the cell widths,
///
///     -lambda E[Y^3]/6 delta_l^3 p / l^3 + lambda E[Y^4]/24 delta_l^4 p / l^4.
///
/// In the literal scheme of `km4` the step l of the differences is the cell width.
Excitation kramers_moyal_excitation(const problem::ImpulseTrain& impulses, const Axis& axis,
                                    double regularisation_length);

/// The [2/2] Pade approximant of the truncated Kramers-Moyal series. With D_j = lambda E[Y^j]/j!, a
/// = D3/D2 and b = D4/D2 - a^2,
///
///     -D1 p' + (1 + a d/dx2 - b d^2/dx2^2)^(-1) D2 p''.
///
/// For a symmetric law of the amplitudes the Pade approximant is the generator of a compound
/// Poisson process with Laplace jumps. The Pade approximant exists for b > 0.
/// @param scheme_order order of accuracy of the differences, even
Excitation kramers_moyal_pade_excitation(const problem::ImpulseTrain& impulses, const Axis& axis,
                                         int scheme_order);

/// The coefficient b of kramers_moyal_pade_excitation; positive if the Pade approximant is a
/// bounded operator.
double pade_length_squared(const problem::ImpulseTrain& impulses);

/// The excitation by the jump integral lambda (E[p(x2 - Y)] - p).
Excitation jump_excitation(const problem::ImpulseTrain& impulses, const Axis& axis);

/// The matrix of drift and diffusion of the excitation on cell averages of the velocity axis, shape
/// (cells, cells). Drift and diffusion are discretised by differences of the given even order of
/// accuracy.
AxisOperator local_excitation(const Axis& axis, const Excitation& excitation, int scheme_order);

class Axis;
struct Excitation;

/// The wave exp(i q x2) of the velocity x2 that grows fastest under an excitation alone.
struct FastestGrowingWave {
  double rate;        ///< largest real part of the symbol for 0 < q <= pi/step, per unit time
  double wavenumber;  ///< the wavenumber q of the maximum
};

/// Computes the fastest growing wave from the symbol of the discrete excitation. The symbol is
/// computed from the middle row of the excitation matrix on a uniform axis. The axis must be so
/// long that its middle row contains no stencils of the two ends. A positive growth rate means that
/// the discrete equation is unstable, with larger growth rates on finer grids: the truncated
/// Kramers-Moyal series acts on exp(i q x2) as -D2 q^2 + D4 q^4, with D4 > 0.
/// @param stencil_size number of cells in a stencil of the centred differences, even
FastestGrowingWave fastest_growing_wave(const Axis& axis, const Excitation& excitation,
                                        int stencil_size);

/// Largest number of cells on each side of the middle cell that contribute to the middle row of the
/// excitation matrix.
int stencil_half_width_in_cells(double regularisation_length, double cell_width, int stencil_size);

/// Whether the growth rate of a wave exceeds zero by more than rounding errors.
bool is_unstable(const FastestGrowingWave& growth, const problem::ImpulseTrain& impulses);

/// Shortest regularisation length l with which -D2 q^2 + D4 (2 sin(q l / 2) / l)^4 <= 0 for all q:
/// l^2 = 4 max_t(sin^4 t / t^2) D4/D2 with D2 = lambda E[Y^2]/2, D4 = lambda E[Y^4]/24.
double shortest_regularisation_length(const problem::ImpulseLaw& law);

/// Returns, in increasing order, the cell widths of an axis for which kramers_moyal_excitation with
/// the regularisation length l may be unstable. Widths less than a twentieth above the preceding
/// width are omitted. If l is at least the default regularisation length of the law, the critical
/// cells are those wider than l/2, for every law. Reason: D4 / (D2 l^2) is then at most 5/12, the
/// value for the two-point law. Up to the ratio D4 / (D2 l^2) = 5/12 the scheme is stable on cells
/// not wider than l/2, for differences of every order.
std::vector<double> critical_cell_widths(const Axis& axis, const problem::ImpulseLaw& law,
                                         double regularisation_length);

/// The shortest regularisation length, at least `min_length`, with which kramers_moyal_excitation
/// is stable on cells of all given widths, to a relative tolerance of a thousandth. On cells about
/// as wide as the length, or wider, the second difference damps short waves less than the exact
/// derivative does, and the fourth difference interpolates between cells. On such cells a
/// regularisation length for which the continuous symbol is stable may be too short.
/// @param stencil_size number of cells in a stencil of the centred differences, even
double shortest_regularisation_length(const problem::ImpulseTrain& impulses,
                                      std::span<const double> widths, int stencil_size,
                                      double min_length);

/// The default regularisation length on the cells of an axis: default_regularisation_length of the
/// law, or a longer length if stability on these cells requires a longer length. For schemes of
/// order 3 and higher, on cells up to ten times as wide as the default length of the law, stability
/// increases the length by less than a half.
double default_regularisation_length(const problem::ImpulseTrain& impulses, const Axis& axis,
                                     int stencil_size);

}  // namespace fpkcheck::fd_fpk
