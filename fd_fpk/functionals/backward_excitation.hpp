#pragma once

#include <functional>

#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Terms of the backward equation besides the motion: a drift and a diffusion of v, and impulses.
struct BackwardEquationExcitation {
  double drift = 0;
  double diffusion = 0;
  double impulse_rate = 0;  ///< 0 without impulses
  const problem::ImpulseLaw* law = nullptr;

  /// Returns the terms of the equation `white` or `kf`, without noise.factor and impulse.factor.
  /// @param problem must outlive the result
  static BackwardEquationExcitation of_equation(const problem::Problem& problem,
                                                DensityEquation equation);

  /// Calls `add` with amplitudes and weights of a quadrature rule of E[f(Y)] over the amplitudes Y
  /// between two limits: Gauss rules between the breakpoints of the density, and the atoms.
  /// @pre impulse_rate > 0
  void for_each_amplitude(double from, double to,
                          const std::function<void(double amplitude, double weight)>& add) const;
};

}  // namespace fpkcheck::fd_fpk
