#include "transform/passage.hpp"

#include <cmath>

#include "problem/effective_potential.hpp"

namespace fpkcheck::transform {

std::optional<PassageStartState> passage_start_state(const problem::Problem& transformed,
                                                     double barrier,
                                                     const std::optional<PassageStartState>& given,
                                                     const std::optional<double>& lower_barrier) {
  if (given) {
    return PassageStartState{transformed.frame.wall_coordinate(given->y),
                             transformed.frame.physical_velocity(given->ydot)};
  }
  const auto rest = problem::rest_displacement(transformed, barrier, lower_barrier);
  if (!rest) return std::nullopt;
  return PassageStartState{*rest, 0};
}

double energy_level_in_wall_coordinates(const problem::Problem& transformed, double energy) {
  return energy +
         problem::EffectivePotential(transformed.system)(transformed.frame.wall_coordinate(0));
}

std::vector<double> automatic_survival_times(double mean_passage_time) {
  std::vector<double> times;
  for (int k = 1; k <= 10; ++k) {
    const double time = 0.3 * k * mean_passage_time,
                 unit = std::pow(10, std::floor(std::log10(time)) - 1);
    times.push_back(std::round(time / unit) * unit);
  }
  return times;
}

}  // namespace fpkcheck::transform
