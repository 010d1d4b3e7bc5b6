#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "base/options/option_description.hpp"
#include "problem/expression/expression.hpp"

namespace fpkcheck::problem {

/// Least restitution coefficient of a formula r(u) at impact speeds above the range that
/// require_valid_restitution() checks. The value of kSmallestRestitution is arbitrary but positive,
/// so that the mass leaves the wall after an impact.
inline constexpr double kSmallestRestitution = 1e-6;

/// A rigid wall, at which an impact multiplies the velocity y' by -r.
struct Wall {
  double position;
  /// Restitution coefficient r, 0 < r <= 1; of a formula r(u) its value at the impact speed u = 0.
  double restitution;
  /// Formula of the restitution coefficient r(u), where the variable v denotes the impact speed u;
  /// null for a constant restitution coefficient.
  std::shared_ptr<const Expression> restitution_formula = {};

  bool has_constant_restitution() const { return !restitution_formula; }
  /// Returns the restitution coefficient r(u) at an impact speed u >= 0.
  double restitution_at_speed(double impact_speed) const {
    return restitution_formula
               ? std::clamp((*restitution_formula)(0.0, impact_speed), kSmallestRestitution, 1.0)
               : restitution;
  }
  bool operator==(const Wall&) const = default;
};

/// Positions and restitution coefficients of the walls between which the mass moves, from the
/// section [wall] of a case file.
struct WallParameters {
  std::optional<double> left = {};
  std::optional<base::NumberOrFormula> left_restitution = {};
  std::optional<double> right = {};
  std::optional<base::NumberOrFormula> right_restitution = {};
  bool none = false;  ///< whether the case file states that there is no wall

  bool operator==(const WallParameters&) const = default;
  bool is_section_absent() const { return *this == WallParameters{}; }
};

const base::OptionsDescription<WallParameters>& wall_parameter_description();

/// The walls at the ends of the range of the displacement y; absent on an unbounded side.
struct Walls {
  std::optional<Wall> left, right;
};

/// Returns the walls of the section [wall] of a case file. Without a section [wall], the only wall
/// is at y = 0 on the left and has the `restitution` of the section [system].
/// @param constants named constants of the formulas of restitution coefficients
/// @throws InputError if both or neither of the section [wall] and `restitution` are given; if a
/// wall lacks its position or its restitution coefficient; if a formula is invalid; or if the
/// position of the left wall is not below the position of the right wall
Walls make_walls(const WallParameters& parameters, const std::optional<double>& restitution,
                 const NamedConstants& constants = {});

/// Returns the impact speed u before an impact for the speed v = u r(u) after the impact; 0 for v
/// <= 0. If no impact speed u satisfies u r(u) = v, speed_before_impact() returns a speed far above
/// all speeds of the motion.
double speed_before_impact(const Wall& wall, double speed_after);

/// Requires 0 < r(u) <= 1 and an increasing speed u r(u) after the impact, for impact speeds
/// u <= `largest_speed`.
/// @throws InputError that states the key and a speed at which a formula r(u) is invalid
void require_valid_restitution(const Walls& walls, double largest_speed);

class System;
struct Problem;

/// Transformation between the physical coordinate y of a problem and its wall coordinate x: y =
/// origin + x, or, if mirrored, y = origin - x with the opposite sign of velocities. In wall
/// coordinates the first wall is at x = 0, the mass is at x > 0, and a second wall is on the right.
/// For a problem with one wall at y = 0 on the left, or without walls, the wall coordinate x equals
/// y.
struct WallFrame {
  double origin = 0;
  bool mirrored = false;

  double velocity_sign() const { return mirrored ? -1 : 1; }
  double physical_y(double x) const { return origin + velocity_sign() * x; }
  double wall_coordinate(double y) const { return velocity_sign() * (y - origin); }
  double physical_velocity(double x_dot) const { return velocity_sign() * x_dot; }
  bool is_identity() const { return origin == 0 && !mirrored; }
  WallFrame inverse_frame() const {
    return {.origin = -velocity_sign() * origin + 0.0, .mirrored = mirrored};  // adding 0 avoids -0
  }
  bool operator==(const WallFrame&) const = default;
};

/// Returns the transformation to wall coordinates, with the origin at the left wall, or at the
/// right wall if the system has no left wall.
WallFrame wall_frame(const System& system);

/// Transforms a problem to the wall coordinates of `frame` and sets Problem::frame. If the
/// transformation `frame` is the identity, the problem is returned unchanged. The transformed
/// problem keeps the name and the case-file parameters of the problem.
Problem to_wall_coordinates(const WallFrame& frame, const Problem& problem);

}  // namespace fpkcheck::problem
