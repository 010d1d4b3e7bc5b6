#include "fd_fpk/functionals/backward_excitation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fd_fpk/axis/excitation.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::fd_fpk {

BackwardEquationExcitation BackwardEquationExcitation::of_equation(const problem::Problem& problem,
                                                                   DensityEquation equation) {
  BackwardEquationExcitation excitation{.diffusion = problem.noise.diffusion()};
  if (!problem.impulses.is_acting()) return excitation;
  if (equation == DensityEquation::white) {
    const DiscretisedExcitation white = white_noise_excitation(problem.impulses);
    excitation.drift = white.drift;
    excitation.diffusion += white.diffusion;
  } else {
    excitation.impulse_rate = problem.impulses.arrival_rate();
    excitation.law = &problem.impulses.amplitude_law();
  }
  return excitation;
}

void BackwardEquationExcitation::for_each_amplitude(
    double from, double to, const std::function<void(double amplitude, double weight)>& add) const {
  assert(impulse_rate > 0);
  const auto pieces = law->amplitude_density_breakpoints();
  for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
    const double low = std::max(pieces[piece], from), high = std::min(pieces[piece + 1], to);
    if (low >= high) continue;
    const int panels =
        static_cast<int>(std::ceil((high - low) / law->amplitude_standard_deviation()));
    for (const auto& [amplitude, weight] : numerics::composite_gauss_points<8>(low, high, panels)) {
      add(amplitude, weight * law->density(amplitude));
    }
  }
  for (const auto& [amplitude, probability] : law->amplitude_atoms()) {
    if (from < amplitude && amplitude < to) add(amplitude, probability);
  }
}

}  // namespace fpkcheck::fd_fpk
