#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fd_fpk/axis/axis_operators.hpp"
#include "problem/excitation.hpp"

namespace fpkcheck::fd_fpk {

/// Diffusion coefficient D(x1, x2) in the term (D p)'' of multiplicative noise or parametric
/// impulses.
struct StateDependentDiffusion {
  std::function<double(double x1, double x2)> coefficient;
  /// Derivative of the diffusion coefficient D with respect to the velocity x2; empty if D depends
  /// only on the displacement x1
  std::function<double(double x1, double x2)> slope_in_x2 = {};
};

/// Parametric impulses: an impulse of amplitude Y changes the velocity by b(x1) Y, with a factor b
/// that depends on the displacement x1.
struct ParametricImpulses {
  problem::ImpulseTrain train;
  problem::StateFunction factor;
};

/// Excitation terms of the density equation, discretised on a velocity axis.
struct DiscretisedExcitation {
  double drift = 0;      ///< drift coefficient a in the term -a p'
  double diffusion = 0;  ///< diffusion coefficient D in the term D p''
  /// Matrix of the nonlocal excitation terms, shape (cells, cells): velocity jumps, third and
  /// fourth differences of the truncated Kramers-Moyal equation `km4`, or the Pade approximant. The
  /// exchange matrix conserves mass: the row vector of cell widths times the matrix is zero.
  Eigen::MatrixXd exchange;
  /// Drift, diffusion and decay rate by which the preconditioner approximates the exchange matrix.
  /// The drift and the diffusion approximate the exchange matrix for density waves of long
  /// wavelength. In the preconditioner, density waves of short wavelength decay at the rate
  /// `preconditioner_exchange_decay_rate`.
  double preconditioner_exchange_drift = 0;
  double preconditioner_exchange_diffusion = 0;
  double preconditioner_exchange_decay_rate = 0;
  std::optional<StateDependentDiffusion> state_dependent_diffusion = {};  ///< added to `diffusion`
  /// Parametric impulses, which replace the exchange matrix `exchange`. With parametric impulses,
  /// preconditioner_exchange_diffusion is the diffusion coefficient for the factor b(x1) = 1 of the
  /// impulse amplitude.
  std::optional<ParametricImpulses> parametric = {};

  /// Returns whether the excitation does not depend on the displacement x1 and the velocity x2.
  bool is_state_independent() const { return !state_dependent_diffusion && !parametric; }
};

/// Returns the regularisation length l of the truncated Kramers-Moyal series by the formula l^2 =
/// E[Y^6] / (5 E[Y^4]) without free parameters, where Y is the impulse amplitude. With l = (E[Y^6]
/// / (5 E[Y^4]))^(1/2) the leading error of the fourth difference with the step l equals the sixth
/// term of the Kramers-Moyal series. The scheme with this regularisation length is well-posed,
/// since E[Y^6]/E[Y^4] >= E[Y^4]/E[Y^2] (Cauchy-Schwarz).
double default_regularisation_length(const problem::ImpulseLaw& law);

/// Returns the white-noise approximation -lambda E[Y] p' + lambda E[Y^2]/2 p'' of impulses with the
/// rate lambda and the amplitude Y.
DiscretisedExcitation white_noise_excitation(const problem::ImpulseTrain& impulses);

/// Returns the Kramers-Moyal series truncated after the fourth derivative, as the sum of drift,
/// diffusion and two finite differences over a fixed velocity step l:
///
///     -lambda E[Y^3]/6 delta_l^3 p / l^3 + lambda E[Y^4]/24 delta_l^4 p / l^4.
///
/// In the literal scheme of the equation `km4`, the step l of the differences is the cell width.
DiscretisedExcitation kramers_moyal_excitation(const problem::ImpulseTrain& impulses,
                                               const GridAxis& axis, double regularisation_length);

/// Returns the [2/2] Pade approximant of the truncated Kramers-Moyal series, with the Kramers-Moyal
/// coefficients D_j = lambda E[Y^j]/j!, a = D3/D2 and b = D4/D2 - a^2:
///
///     -D1 p' + (1 + a d/dx2 - b d^2/dx2^2)^(-1) D2 p''.
///
/// For a symmetric law of the amplitudes, the Pade approximant is the generator of a compound
/// Poisson process with Laplace-distributed jumps. The Pade approximant exists if the squared
/// kernel length b = D4/D2 - (D3/D2)^2 is positive.
/// @param scheme_order even order of accuracy of the finite differences
DiscretisedExcitation kramers_moyal_pade_excitation(const problem::ImpulseTrain& impulses,
                                                    const GridAxis& axis, int scheme_order);

/// Returns the squared kernel length b = D4/D2 - (D3/D2)^2 of the Pade approximant of the
/// Kramers-Moyal series. The Pade approximant is a bounded operator if this squared length is
/// positive.
double pade_kernel_length_squared(const problem::ImpulseTrain& impulses);

/// Returns the excitation terms of the exact jump integral lambda (E[p(x2 - Y)] - p) of impulses
/// with the rate lambda and the amplitude Y.
DiscretisedExcitation jump_excitation(const problem::ImpulseTrain& impulses, const GridAxis& axis);

/// Returns the matrix, shape (cells, cells), of the drift and diffusion terms of the excitation on
/// the cell averages of the velocity axis. The finite differences of drift and diffusion have the
/// given even order of accuracy.
AxisOperator drift_diffusion_matrix(const GridAxis& axis, const DiscretisedExcitation& excitation,
                                    int scheme_order);

class GridAxis;
struct DiscretisedExcitation;

/// The wave exp(i q x2) of the density that grows fastest under the excitation without transport.
struct FastestGrowingWave {
  double rate;        ///< largest real part of the symbol for 0 < q <= pi/step, per unit time
  double wavenumber;  ///< wavenumber q of the largest real part of the symbol
};

/// Computes the fastest growing wave from the symbol of the discrete excitation. The Fourier symbol
/// of the excitation follows from the middle row of the excitation matrix. The velocity axis must
/// have uniform cells, and must be so long that no stencil in the middle row of the excitation
/// matrix is shifted by an end of the axis. A positive growth rate means that the discrete equation
/// is unstable. The truncated Kramers-Moyal series has the symbol -D2 q^2 + D4 q^4 with D4 > 0, so
/// that the growth rate increases on finer grids.
/// @param stencil_size even number of cells in each stencil of the centred finite differences
FastestGrowingWave fastest_growing_wave(const GridAxis& axis,
                                        const DiscretisedExcitation& excitation, int stencil_size);

/// Returns the largest number of cells on each side of the middle cell that contribute to the
/// middle row of the excitation matrix.
int excitation_half_bandwidth(double regularisation_length, double cell_width, int stencil_size);

/// Returns whether the growth rate of a density wave exceeds zero by more than rounding errors.
bool is_growing_wave(const FastestGrowingWave& wave, const problem::ImpulseTrain& impulses);

/// Returns the shortest regularisation length l for which the symbol -D2 q^2 + D4 (2 sin(q l / 2) /
/// l)^4 of the truncated Kramers-Moyal series is <= 0 for all wavenumbers q. The shortest stable
/// regularisation length l satisfies l^2 = 4 max_t(sin^4 t / t^2) D4/D2.
double shortest_stable_regularisation_length(const problem::ImpulseLaw& law);

/// Returns the cell widths of an axis for which kramers_moyal_excitation() with the regularisation
/// length l may be unstable, in increasing order. The list of possibly unstable cell widths omits
/// cell widths less than 5 % above the preceding cell width in the list. If the regularisation
/// length l is at least the default length of the impulse law, the truncated Kramers-Moyal series
/// can be unstable only on cells wider than l/2, since D4 / (D2 l^2) is at most 5/12. Up to D4 /
/// (D2 l^2) = 5/12, the value of the two-point law, finite differences of every order are stable on
/// cells not wider than half of the regularisation length l.
std::vector<double> possibly_unstable_cell_widths(const GridAxis& axis,
                                                  const problem::ImpulseLaw& law,
                                                  double regularisation_length);

/// Returns the shortest regularisation length, at least `min_length`, for which
/// kramers_moyal_excitation() is stable on cells of all given widths. A regularisation length l for
/// which the symbol of the differential equation is stable may be unstable on cells of the width l.
/// @param stencil_size even number of cells in each stencil of the centred finite differences
double shortest_stable_regularisation_length(const problem::ImpulseTrain& impulses,
                                             std::span<const double> widths, int stencil_size,
                                             double min_length);

/// Returns the default regularisation length of the impulse law, increased if stability on the
/// cells of the axis requires a longer length. For schemes of order 3 and higher, the returned
/// regularisation length is at most 1.5 times the default length on cells up to ten times as wide
/// as the default length.
double default_regularisation_length(const problem::ImpulseTrain& impulses, const GridAxis& axis,
                                     int stencil_size);

}  // namespace fpkcheck::fd_fpk
