#include "epc/selection_policy.hpp"

#include <cmath>

#include "problem/equivalent_linearisation.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::epc {

// The Gaussian initial density is used for a density with one peak at the wall and a force without
// other equilibria. The root searches from the Gaussian and from the energy-averaged density give
// the same closures of order 4 to 8 in cases 1 to 4. Only at closure order 8 do the two initial
// densities lead to moments that differ by 1e-5, since the confinement levels differ by up to 7 %.
// At order 16, the search from the energy-averaged density finds only inadmissible roots in cases 2
// to 4, and takes 5 s instead of the 0.7 s from the Gaussian density.
bool starts_from_equivalent_linearisation(const problem::Problem& problem) {
  return problem::has_equivalent_linearisation(problem);
}

// The Gaussian weights of the paper have the standard deviations of equivalent linearisation. With
// Gaussian weights widened by the static deflection, the root search fails at order 6 for a
// restitution coefficient r = 0.9 and a mean impulse of 0.2.
StandardDeviations gaussian_weight_deviations(const problem::Problem& problem) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const double centre = problem::has_equivalent_linearisation(problem) ? 0 : scales.centre;
  return {std::hypot(scales.displacement_deviation, centre), scales.velocity_deviation};
}

}  // namespace fpkcheck::epc
