#include "workflows/sweep/map/map_coordinates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace fpkcheck::sweep {

MapCoordinates map_coordinates(const problem::Problem& problem) {
  const auto& impulses = problem.impulses.parameters();
  const auto& law = problem.impulses.law();
  return {.groups = dimensionless_groups(problem),
          .restitution = problem.system.restitution(),
          .law = law.is_symmetric()
                     ? impulses.law
                     : fmt::format("{} of skewness {:g}", impulses.law, law.skewness()),
          .relative_mean = impulses.mean / std::sqrt(impulses.intensity / impulses.arrival_rate)};
}

double map_distance(const MapCoordinates& one, const MapCoordinates& other) {
  constexpr double kRestitutionUnit = 0.1, kCubicUnit = 0.2;
  if (one.law != other.law || one.relative_mean != other.relative_mean) {
    return std::numeric_limits<double>::infinity();
  }
  const double impulses =
      std::log(one.groups.impulses_per_decay_time / other.groups.impulses_per_decay_time);
  const double damping = std::log(one.groups.damping_ratio / other.groups.damping_ratio);
  const double losses = (one.restitution - other.restitution) / kRestitutionUnit;
  const double cubic = (one.groups.cubic_share - other.groups.cubic_share) / kCubicUnit;
  return std::hypot(std::hypot(impulses, damping), std::hypot(losses, cubic));
}

}  // namespace fpkcheck::sweep
