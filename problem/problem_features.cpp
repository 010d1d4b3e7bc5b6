#include "problem/problem_features.hpp"

#include <fmt/format.h>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <vector>

#include "problem/equivalent_linearisation.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {

ProblemFeatures problem_features(const Problem& problem) {
  const System& system = problem.system;
  ProblemFeatures result{.no_wall = !system.left_wall() && !system.right_wall(),
                         .two_walls = system.left_wall() && system.right_wall(),
                         .noise = problem.noise.is_acting(),
                         .impulses = problem.impulses.is_acting(),
                         .constant_damping = system.has_constant_damping()};
  const auto& c = system.coefficients();
  result.negative_damping = c.damping < 0 || c.van_der_pol < 0 || c.rayleigh < 0;
  const auto inspect_wall = [&](const std::optional<Wall>& wall, double towards) {
    if (!wall) return;
    // The restoring force -g(y) presses the mass against a left wall if g(y) > 0 at the wall.
    const double pressing = -towards * system.force(wall->position, 0);
    const bool is_elastic = wall->has_constant_restitution() && wall->restitution == 1;
    if (pressing > 0 && !is_elastic && !result.noise) result.rests_in_contact = true;
    if (result.noise && wall->restitution <= kCollapseRestitution) result.collapse = true;
  };
  inspect_wall(system.left_wall(), -1);
  inspect_wall(system.right_wall(), 1);
  if (!has_equivalent_linearisation(problem))
    result.wells = static_cast<int>(UndampedOrbits(problem).potential_minima().size());
  return result;
}

std::string polynomial_method_unsupported_reason(const Problem& problem) {
  if (problem.noise_factor) {
    return "the noise is multiplied by the factor noise.factor; use fd or mcs";
  }
  if (problem.impulse_factor) {
    return "the impulses are multiplied by the factor impulse.factor; use fd or mcs";
  }
  if (!problem.system.has_constant_restitution()) {
    return "the restitution coefficient depends on the impact speed; use fd or mcs";
  }
  if (problem.system.has_polynomial_force()) return "";
  return "the force is not one of the polynomials that this method supports; use fd or mcs";
}

std::string inelastic_collapse_reason(const Problem& problem, DensityEquation equation) {
  const bool noise = problem.noise.is_acting();
  if (!noise && equation != DensityEquation::white) return "";
  for (const auto& wall : {problem.system.left_wall(), problem.system.right_wall()}) {
    if (!wall || wall->restitution > kCollapseRestitution) continue;
    return fmt::format(
        "white noise and restitution {:.3g} lead to inelastic collapse, after which the motion is "
        "undefined; {}take a restitution above exp(-pi/sqrt 3) = {:.4f}",
        wall->restitution, noise ? "" : "solve kf, or ", kCollapseRestitution);
  }
  return "";
}

std::string barrier_unsupported_reason(const Problem& problem, double barrier) {
  if (problem.frame.mirrored) {
    return "a passage above a barrier is not supported with a wall on the right alone; mirror the "
           "case";
  }
  const auto &left = problem.system.left_wall(), &right = problem.system.right_wall();
  if ((left && barrier <= left->position) || (right && barrier >= right->position)) {
    return fmt::format("the barrier y = {:g} is not between the walls; choose another barrier",
                       problem.frame.physical_y(barrier));
  }
  return "";
}

const std::vector<UnsupportedOscillatorFeature>& unsupported_features() {
  static const std::vector<UnsupportedOscillatorFeature> all{
      {"coloured noise", {"coloured", "colored", "correlation", "bandwidth", "filter"}},
      {"impulses other than a Poisson process", {"renewal", "arrivals", "interarrival", "levy"}},
      {"two or more degrees of freedom", {"dof", "freedom", "coupling", "oscillators"}},
      {"hysteresis, delay or fractional damping", {"hysteresis", "delay", "fractional"}},
      {"soft or moving walls", {"contact", "compliance", "moving"}}};
  return all;
}

std::string unsupported_feature_message(std::string_view key_or_command) {
  static const std::vector<std::string> words_of_forcing{"forcing", "harmonic", "periodic",
                                                         "sinusoidal", "frequency"};
  std::vector<std::string> parts;
  const std::string lower = boost::algorithm::to_lower_copy(std::string(key_or_command));
  boost::algorithm::split(parts, lower, boost::algorithm::is_any_of("._-"));
  if (std::ranges::find_first_of(parts, words_of_forcing) != parts.end()) {
    return "not a key; a force F(t) is a formula, e.g. time.force = 0.3*cos(1.2*t)";
  }
  for (const auto& [subject, words] : unsupported_features()) {
    const bool is_named = std::ranges::find_first_of(parts, words) != parts.end();
    if (is_named) {
      return fmt::format("the program does not treat {}; see docs/not_treated.md", subject);
    }
  }
  return "";
}

}  // namespace fpkcheck::problem
