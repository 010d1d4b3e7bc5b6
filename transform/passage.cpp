#include "transform/passage.hpp"

#include "problem/effective_potential.hpp"

namespace fpkcheck::transform {

std::optional<StartState> passage_start(const problem::Problem& transformed, double barrier,
                                        const std::optional<StartState>& given) {
  if (given) {
    return StartState{transformed.frame.wall_x(given->y),
                      transformed.frame.physical_velocity(given->ydot)};
  }
  const auto rest = problem::rest_displacement(transformed, barrier);
  return rest ? std::optional(StartState{*rest, 0}) : std::nullopt;
}

double energy_level_in_wall_coordinates(const problem::Problem& transformed, double energy) {
  return energy + problem::EffectivePotential(transformed.system)(transformed.frame.wall_x(0));
}

}  // namespace fpkcheck::transform
