#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Properties of a problem that decide which solvers are applicable.
struct ProblemFeatures {
  bool no_wall = false, two_walls = false;
  /// Whether the force presses the mass against a wall with r < 1 and there is no noise. After a
  /// sequence of impacts the mass is then at rest in contact until the next impulse, and the
  /// stationary law has an atom at the wall.
  bool rests_in_contact = false;
  /// Whether inelastic collapse occurs: there is noise, and r <= kCollapseRestitution at a wall.
  bool collapse = false;
  bool noise = false, impulses = true;
  bool constant_damping = true;   ///< whether the damping force is f = c y'
  bool negative_damping = false;  ///< whether c or another coefficient of f is negative
  int wells = 1;  ///< number of minima of U - lambda E[Y] y, minima at walls included
};

ProblemFeatures features(const Problem& problem);

/// The critical restitution coefficient exp(-pi / sqrt 3). For restitution coefficients up to this
/// value, a particle under white noise makes infinitely many impacts in a finite time and comes to
/// rest on the wall (inelastic collapse; S. J. Cornell, M. R. Swift, A. J. Bray, Phys. Rev. Lett.
/// 81, 1142 (1998)). The law by which the particle leaves the wall again is determined neither by
/// the equation nor by the impact condition.
inline constexpr double kCollapseRestitution = 0.16303353482158048;

/// Explains why the equation and the impact condition at one of the walls leave the stationary
/// density undetermined, and which change of the problem helps. Empty if the density is determined.
/// Discrete impulses separate the particle from the wall, so that inelastic collapse needs white
/// noise: the noise of the problem, for every equation; or the noise by which the equation `white`
/// replaces the impulses.
std::string inelastic_collapse_reason(const Problem& problem, Equation equation);

/// A feature that the program does not support, with the words by which keys of case files and
/// commands request the feature.
struct UnsupportedFeature {
  std::string_view subject;  ///< name of the feature: "dry friction"
  /// Words in lower case. Each word is compared with the parts into which '.' and '_' split a key.
  std::vector<std::string_view> words;
};

/// All unsupported features, in agreement with the list in README.md.
const std::vector<UnsupportedFeature>& unsupported_features();

/// One line that names the unsupported feature which a key or a command requests. Empty if the name
/// requests no unsupported feature.
/// @param name key or command: "system.friction", "passage"
std::string unsupported_feature_message(std::string_view name);

}  // namespace fpkcheck::problem
