#include "problem/inelastic_collapse.hpp"

#include <fmt/format.h>

namespace fpkcheck::problem {

std::string collapse_objection(const Problem& problem, Equation equation) {
  const double r = problem.system.restitution();
  if (equation != Equation::white || r > kCollapseRestitution) return "";
  return fmt::format(
      "under white noise impacts with restitution {:.3g} accumulate to rest on the wall, and nothing "
      "says how the motion leaves it (solve kf, or take a restitution above exp(-pi/sqrt 3) = "
      "{:.4f})",
      r, kCollapseRestitution);
}

}  // namespace fpkcheck::problem
