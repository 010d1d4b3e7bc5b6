#pragma once

#include <string_view>
#include <vector>

#include "fd_fpk/line_operators.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// The excitation term of the density equation.
enum class Equation {
  white,  ///< -lambda E[Y] p' + D2 p'', D2 = lambda E[Y^2]/2
  km4,    ///< the Kramers-Moyal series cut after the fourth derivative: paper (16), (20)
  kf      ///< the full jump integral lambda (E[p(x2 - Y)] - p)
};

/// The equation's name in summaries and options: "white", "km4", "kf".
std::string_view name(Equation equation);

/// One term weight p(x2 - shift step) of an operator on a velocity lattice.
struct LatticeTerm {
  int shift;      ///< in cells
  double weight;  ///< per unit time
};

/// The excitation on a velocity line of a given step: derivatives by differences on the line
/// itself, and shifts by whole cells. The weights of the shifts sum to zero.
struct Excitation {
  double drift = 0;                  ///< a in -a p'
  double diffusion = 0;              ///< D in D p''
  std::vector<LatticeTerm> lattice;  ///< the jumps (kf), or third and fourth differences (km4)
};

/// Parameter-free regularisation length of `km4`: l^2 = E[Y^6] / (5 E[Y^4]). The leading error of
/// the fourth difference with step l is then the sixth Kramers-Moyal term, and the scheme is
/// well-posed, since E[Y^6]/E[Y^4] >= E[Y^4]/E[Y^2]. For a zero-mean gaussian l is the deviation of
/// Y.
double default_regularisation_length(const problem::ImpulseLaw& law);

/// Largest spacing of the jump lattice of `kf`: the deviation s of Y, where the trapezoidal rule's
/// aliasing error is 2 exp(-2 pi^2) = 5e-9; half of it for rare impulses, lambda/c < 10, whose
/// density keeps finer structure than the lattice would show.
double largest_jump_spacing(const problem::Problem& problem);

/// White noise: -lambda E[Y] p' + lambda E[Y^2]/2 p''.
Excitation white_noise(const problem::ImpulseTrain& impulses);

/// `white` and, with differences of fixed step l = `cells` velocity steps,
///
///     -lambda E[Y^3]/6 delta_l^3 p / l^3 + lambda E[Y^4]/24 delta_l^4 p / l^4.
///
/// cells = 1 is the literal scheme.
Excitation kramers_moyal(const problem::ImpulseTrain& impulses, double step, int cells);

/// lambda (sum_k w_k p(x2 - k d) - p), w_k ~ f_Y(k d), on a lattice of spacing d = `cells` steps.
Excitation jumps(const problem::ImpulseTrain& impulses, double step, int cells);

/// The excitation as a matrix on cell averages of the velocity line, shape (cells, cells); the
/// derivatives to the given even order. Jumps that would leave the line do not take place, so
/// columns sum to zero.
LineOperator excitation_operator(const UniformLine& line, const Excitation& excitation, int order);

}  // namespace fpkcheck::fd_fpk
