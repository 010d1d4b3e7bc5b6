#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problem/equation_and_impact_condition.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Properties of a problem that decide which solvers are applicable.
struct ProblemFeatures {
  bool no_wall = false, two_walls = false;
  /// Whether the restoring force presses the mass against a wall with restitution coefficient r <
  /// 1, and no noise acts. After a sequence of impacts the mass is then at rest in contact until
  /// the next impulse, and the stationary law has an atom at the wall.
  bool rests_in_contact = false;
  /// Whether inelastic collapse occurs, that is, noise acts and a wall has a restitution
  /// coefficient r <= kCollapseRestitution.
  bool collapse = false;
  bool noise = false, impulses = true;  ///< whether white noise acts, and whether impulses act
  bool constant_damping = true;
  bool negative_damping = false;  ///< whether c or another coefficient of f is negative
  int wells = 1;  ///< number of minima of U - lambda E[Y] y, minima at walls included
};

ProblemFeatures problem_features(const Problem& problem);

/// Returns the reason why a method for polynomial problems does not support a problem; an empty
/// text for a polynomial problem. A polynomial problem has a polynomial force, noise and impulses
/// without a factor, and constant restitution coefficients.
std::string polynomial_method_unsupported_reason(const Problem& problem);

/// Critical restitution coefficient exp(-pi / sqrt 3) of inelastic collapse (Cornell, Swift and
/// Bray, Physical Review Letters 81, 1142 (1998)). For restitution coefficients up to the critical
/// value of inelastic collapse, a particle under white noise makes infinitely many impacts in a
/// finite time and comes to rest on the wall. After inelastic collapse, neither the equation of
/// motion nor the impact condition determines how the particle leaves the wall.
inline constexpr double kCollapseRestitution = 0.16303353482158048;

/// Returns a text that states inelastic collapse and a change of the problem that avoids the
/// collapse; an empty text without inelastic collapse. Inelastic collapse needs white noise, either
/// in the problem or in the density equation `white`, since discrete impulses separate the particle
/// from the wall.
std::string inelastic_collapse_reason(const Problem& problem, DensityEquation equation);

/// Returns the reason why the first passage above a barrier is not defined or not supported; an
/// empty text for a valid barrier.
/// @param problem,barrier problem and barrier in wall coordinates
std::string barrier_unsupported_reason(const Problem& problem, double barrier);

/// A feature of oscillators that the program does not support.
struct UnsupportedOscillatorFeature {
  std::string_view subject;  ///< name of the feature in messages
  /// Words in lower case that identify the unsupported feature in a key of a case file. Keys of a
  /// case file are split into words at '.', '_' and '-'.
  std::vector<std::string_view> words;
};

/// Returns all unsupported features of oscillators, in agreement with the list in README.md.
const std::vector<UnsupportedOscillatorFeature>& unsupported_features();

/// Returns one line that names the unsupported feature that a key or a command requests, or the key
/// of a force that changes in time; empty for other keys and commands.
std::string unsupported_feature_message(std::string_view key_or_command);

}  // namespace fpkcheck::problem
