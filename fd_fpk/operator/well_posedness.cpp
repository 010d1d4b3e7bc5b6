#include "fd_fpk/operator/well_posedness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace fpkcheck::fd_fpk {
namespace {

// Returns the regularisation length rounded up to three digits, since the printed length must be
// sufficient for stability.
double round_up_to_three_digits(double length) {
  const double digit = std::pow(10, std::floor(std::log10(length)) - 2);
  return std::ceil(length / digit) * digit;
}

// Returns the fastest growing wave over all cell widths of the axis. The discrete excitation may be
// unstable on wide velocity cells and stable on narrow velocity cells.
FastestGrowingWave fastest_growing_wave(const problem::Problem& problem,
                                        const FiniteVolumeOptions& options,
                                        const PlaneDiscretisation& discretisation) {
  const GridAxis& x2 = discretisation.grid.x2;
  FiniteVolumeOptions as_used = options;
  std::vector<double> widths;
  // Only the discrete excitation of the equation `km4` may be unstable; the Pade approximant is
  // always stable.
  if (options.equation == DensityEquation::km4) {
    as_used.regularisation_length = discretisation.regularisation_length;
    widths = possibly_unstable_cell_widths(x2, problem.impulses.amplitude_law(),
                                           discretisation.regularisation_length);
  }
  FastestGrowingWave largest = fastest_growing_wave(problem, as_used, x2.smallest_cell_width());
  for (const double width : widths) {
    const FastestGrowingWave growth = fastest_growing_wave(problem, as_used, width);
    if (growth.rate > largest.rate) largest = growth;
  }
  return largest;
}

std::string regularisation_advice(const problem::ImpulseTrain& impulses, const GridAxis& axis,
                                  int points) {
  constexpr double kNearly = 0.99;
  const auto& law = impulses.amplitude_law();
  const double by_default = default_regularisation_length(impulses, axis, points);
  const double of_law = shortest_stable_regularisation_length(law);
  const double shortest = shortest_stable_regularisation_length(
      impulses, possibly_unstable_cell_widths(axis, law, of_law), points, of_law);
  if (shortest > kNearly * by_default) {
    return fmt::format(
        "leave out the regularisation length: the default on these cells is {:.3g}, and a much "
        "shorter length is ill-posed",
        by_default);
  }
  return fmt::format(
      "use a regularisation length of at least {:.3g} on these cells; the default is {:.3g}",
      round_up_to_three_digits(shortest), by_default);
}

}  // namespace

FastestGrowingWave fastest_growing_wave(const problem::Problem& problem,
                                        const FiniteVolumeOptions& options, double cell_width) {
  const auto [axis, excitation] = unbounded_axis_excitation(problem, options, cell_width);
  return fastest_growing_wave(axis, excitation, centred_stencil_size(transport_order(options)));
}

WellPosednessCheck check_well_posedness(const problem::Problem& problem,
                                        const FiniteVolumeOptions& options,
                                        const PlaneDiscretisation& discretisation) {
  if (options.equation != DensityEquation::km4 && options.equation != DensityEquation::km4_pade)
    return {};
  const auto& impulses = problem.impulses;
  if (!impulses.is_acting()) return {};
  WellPosednessCheck result{.growth = fastest_growing_wave(problem, options, discretisation),
                            .ill_posed_reason = {}};
  if (!is_growing_wave(result.growth, impulses)) return result;
  result.ill_posed_reason = fmt::format(
      "the series truncated after the fourth derivative is ill-posed: with a fourth difference of "
      "step {2:.3g} waves grow at rate {0:.3g} at wavenumber {1:.3g}; {3}",
      result.growth.rate, result.growth.wavenumber, discretisation.regularisation_length,
      regularisation_advice(impulses, discretisation.grid.x2,
                            centred_stencil_size(transport_order(options))));
  return result;
}

}  // namespace fpkcheck::fd_fpk
