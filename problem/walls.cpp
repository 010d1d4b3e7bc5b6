#include "problem/walls.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.hpp"
#include "problem/parameter_ranges.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

using namespace base;

const Description<WallParameters>& wall_parameter_description() {
  using W = WallParameters;
  static const auto description =
      Description<W>("wall.")
          .add("left", &W::left, {"A", "position of the wall on the left"}, finite_numbers())
          .with_symbol("a", "a")
          .with_default_omitted_from_files(Value())
          .add("left_restitution", &W::left_restitution,
               {"R", "coefficient of restitution of the wall on the left"}, restitution_range())
          .with_symbol("r_a", "r_a")
          .with_default_omitted_from_files(Value())
          .add("right", &W::right, {"B", "position of the wall on the right"}, finite_numbers())
          .with_symbol("b", "b")
          .with_default_omitted_from_files(Value())
          .add("right_restitution", &W::right_restitution,
               {"R", "coefficient of restitution of the wall on the right"}, restitution_range())
          .with_symbol("r_b", "r_b")
          .with_default_omitted_from_files(Value())
          .add("none", &W::none, {"", "there is no wall"})
          .with_default_omitted_from_files(false);
  return description;
}

namespace {

std::optional<Wall> wall(const char* side, const std::optional<double>& position,
                         const std::optional<double>& restitution) {
  if (position.has_value() != restitution.has_value()) {
    throw InputError(fmt::format(
        "wall.{0}{1} is missing: a wall has a position and a restitution; give wall.{0} and "
        "wall.{0}_restitution",
        side, position ? "_restitution" : ""));
  }
  if (!position) return std::nullopt;
  return Wall{*position, *restitution};
}

}  // namespace

Walls make_walls(const WallParameters& parameters, const std::optional<double>& restitution) {
  wall_parameter_description().validate(parameters);
  require_magnitudes_in_range(wall_parameter_description(), parameters);
  if (parameters.empty()) {
    if (restitution) return {.left = Wall{0, *restitution}, .right = {}};
    throw InputError(
        "key 'system.restitution' is missing: add it for a wall at y = 0 on the left, or give "
        "wall.left and wall.left_restitution, wall.right and wall.right_restitution, or "
        "wall.none = true");
  }
  if (restitution) {
    throw InputError(fmt::format(
        "system.restitution = {} beside [wall]: it belongs to a wall at y = 0; move it to "
        "wall.left_restitution or wall.right_restitution",
        *restitution));
  }
  const Walls walls{.left = wall("left", parameters.left, parameters.left_restitution),
                    .right = wall("right", parameters.right, parameters.right_restitution)};
  if (parameters.none && (walls.left || walls.right)) {
    throw InputError("wall.none = true beside a wall; remove wall.none, or the keys of the wall");
  }
  if (walls.left && walls.right && !(walls.left->position < walls.right->position)) {
    throw InputError(fmt::format("wall.left = {} (must be below wall.right = {})",
                                 walls.left->position, walls.right->position));
  }
  return walls;
}

WallFrame wall_frame(const System& system) {
  if (system.left_wall()) return {.origin = system.left_wall()->position, .mirrored = false};
  if (system.right_wall()) return {.origin = system.right_wall()->position, .mirrored = true};
  return {};
}

Problem to_wall_coordinates(const WallFrame& frame, const Problem& problem) {
  if (frame.is_identity()) return problem;
  Problem transformed = problem;
  transformed.system = problem.system.to_wall_coordinates(frame);
  transformed.frame = frame;
  if (frame.mirrored) transformed.impulses = problem.impulses.with_negated_amplitudes();
  return transformed;
}

}  // namespace fpkcheck::problem
