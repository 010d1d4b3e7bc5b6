#include "problem/walls.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.hpp"
#include "numerics/roots/bracketed_root.hpp"
#include "problem/parameter_ranges.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

using namespace base;

const OptionsDescription<WallParameters>& wall_parameter_description() {
  using W = WallParameters;
  static const auto description =
      OptionsDescription<W>("wall.")
          .add("left", &W::left, {"A", "position of the wall on the left"}, finite_numbers())
          .with_symbol("a", "a")
          .with_default_omitted_from_files(Value())
          .add("left_restitution", &W::left_restitution,
               {"R",
                "coefficient of restitution of the wall on the left, or a formula of this "
                "coefficient in the impact speed v"},
               admissible_restitution_range())
          .with_symbol("r_a", "r_a")
          .with_default_omitted_from_files(Value())
          .add("right", &W::right, {"B", "position of the wall on the right"}, finite_numbers())
          .with_symbol("b", "b")
          .with_default_omitted_from_files(Value())
          .add("right_restitution", &W::right_restitution,
               {"R",
                "coefficient of restitution of the wall on the right, or a formula of this "
                "coefficient in the impact speed v"},
               admissible_restitution_range())
          .with_symbol("r_b", "r_b")
          .with_default_omitted_from_files(Value())
          .add("none", &W::none, {"", "there is no wall"})
          .with_default_omitted_from_files(false);
  return description;
}

namespace {

void require_valid_wall_restitution(const char* side, const Wall& wall, double largest_speed) {
  constexpr int kSpeeds = 2000;
  double before = 0;
  for (int n = 0; n <= kSpeeds; ++n) {
    // The quadratic spacing of the tested impact speeds resolves low speeds, where powers of the
    // speed change most.
    const double fraction = static_cast<double>(n) / kSpeeds;
    const double u = largest_speed * fraction * fraction;
    const double r =
        wall.restitution_formula ? (*wall.restitution_formula)(0.0, u) : wall.restitution;
    if (!admissible_restitution_range().contains(r)) {
      throw InputError(
          fmt::format("wall.{}_restitution = {:.10g}{} (must be {})", side, r,
                      wall.restitution_formula ? fmt::format(" at the impact speed {:.3g}", u) : "",
                      admissible_restitution_range().requirement));
    }
    if (n > 0 && !(u * r > before)) {
      throw InputError(fmt::format(
          "wall.{}_restitution gives a speed v r(v) after the impact that decreases at the impact "
          "speed {:.3g}; choose a formula for which v r(v) increases",
          side, u));
    }
    before = u * r;
  }
}

std::optional<Wall> make_wall(const char* side, const std::optional<double>& position,
                              const std::optional<NumberOrFormula>& restitution,
                              const NamedConstants& constants) {
  if (position.has_value() != restitution.has_value()) {
    throw InputError(fmt::format(
        "wall.{0}{1} is missing: a wall has a position and a restitution; give wall.{0} and "
        "wall.{0}_restitution",
        side, position ? "_restitution" : ""));
  }
  if (!position) return std::nullopt;
  if (const double* number = restitution->number()) return Wall{*position, *number};
  Expression formula = Expression::parse(restitution->formula(), constants,
                                         fmt::format("wall.{}_restitution", side), "v");
  const double at_rest = formula(0.0, 0.0);
  if (!formula.depends_on_v()) {
    const Wall constant{*position, at_rest};
    require_valid_wall_restitution(side, constant, 1);
    return constant;
  }
  return Wall{*position, at_rest, std::make_shared<const Expression>(std::move(formula))};
}

}  // namespace

double speed_before_impact(const Wall& wall, double speed_after) {
  const double v = speed_after;
  if (v <= 0) return 0;
  if (wall.has_constant_restitution()) return v / wall.restitution;
  constexpr int kMostDoublings = 40;
  double high = v;
  for (int k = 0; k < kMostDoublings && high * wall.restitution_at_speed(high) < v; ++k) high *= 2;
  if (high == v || high * wall.restitution_at_speed(high) < v) return high;
  return numerics::bracketed_root([&](double u) { return u * wall.restitution_at_speed(u) - v; }, v,
                                  high);
}

Walls make_walls(const WallParameters& parameters, const std::optional<double>& restitution,
                 const NamedConstants& constants) {
  wall_parameter_description().validate(parameters);
  require_magnitudes_in_range(wall_parameter_description(), parameters);
  if (parameters.is_section_absent()) {
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
  const Walls walls{
      .left = make_wall("left", parameters.left, parameters.left_restitution, constants),
      .right = make_wall("right", parameters.right, parameters.right_restitution, constants)};
  if (parameters.none && (walls.left || walls.right)) {
    throw InputError("wall.none = true beside a wall; remove wall.none, or the keys of the wall");
  }
  if (walls.left && walls.right && !(walls.left->position < walls.right->position)) {
    throw InputError(fmt::format("wall.left = {} (must be below wall.right = {})",
                                 walls.left->position, walls.right->position));
  }
  return walls;
}

void require_valid_restitution(const Walls& walls, double largest_speed) {
  if (walls.left) require_valid_wall_restitution("left", *walls.left, largest_speed);
  if (walls.right) require_valid_wall_restitution("right", *walls.right, largest_speed);
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
  transformed.time = transformed.time.with_force_sign(frame.velocity_sign());
  if (transformed.noise_factor) {
    transformed.noise_factor = transformed.noise_factor->to_wall_coordinates(frame);
  }
  if (transformed.impulse_factor) {
    transformed.impulse_factor = transformed.impulse_factor->to_wall_coordinates(frame);
  }
  return transformed;
}

}  // namespace fpkcheck::problem
