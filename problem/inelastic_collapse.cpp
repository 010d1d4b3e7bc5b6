#include "problem/inelastic_collapse.hpp"

#include <fmt/format.h>

namespace fpkcheck::problem {

std::string collapse_objection(const Problem& problem, Equation equation) {
  const bool noise = problem.noise.present();
  if (!noise && equation != Equation::white) return "";
  for (const auto& wall : {problem.system.left(), problem.system.right()}) {
    if (!wall || wall->restitution > kCollapseRestitution) continue;
    return fmt::format(
        "under white noise impacts with restitution {:.3g} accumulate to rest on the wall, and "
        "nothing says how the motion leaves it ({}take a restitution above exp(-pi/sqrt 3) = "
        "{:.4f})",
        wall->restitution, noise ? "" : "solve kf, or ", kCollapseRestitution);
  }
  return "";
}

}  // namespace fpkcheck::problem
