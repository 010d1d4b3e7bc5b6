#include "problem/inelastic_collapse.hpp"

#include <fmt/format.h>

namespace fpkcheck::problem {

std::string inelastic_collapse_reason(const Problem& problem, Equation equation) {
  const bool noise = problem.noise.is_present();
  if (!noise && equation != Equation::white) return "";
  for (const auto& wall : {problem.system.left_wall(), problem.system.right_wall()}) {
    if (!wall || wall->restitution > kCollapseRestitution) continue;
    return fmt::format(
        "white noise and restitution {:.3g} lead to inelastic collapse, after which the motion is "
        "undefined; {}take a restitution above exp(-pi/sqrt 3) = {:.4f}",
        wall->restitution, noise ? "" : "solve kf, or ", kCollapseRestitution);
  }
  return "";
}

}  // namespace fpkcheck::problem
