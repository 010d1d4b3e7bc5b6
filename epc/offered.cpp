#include "epc/offered.hpp"

#include "epc/contact/coordinates.hpp"
#include "problem/features.hpp"

namespace fpkcheck::epc {

namespace {

std::string objection_at_walls(const problem::Features& features) {
  if (features.rests_in_contact) {
    return "the mass comes to rest at a wall: an exponential polynomial of y and y' has no atom; "
           "use epc-polar, fd or mcs";
  }
  if (features.collapse) {
    return "impacts accumulate under noise: a restitution coefficient is <= exp(-pi / sqrt 3); "
           "no exponential polynomial has the density at the wall";
  }
  return "";
}

std::string objection_of_gaussian(const problem::Features& features, const Options& options) {
  if (features.two_walls || (!features.no_wall && !features.constant_damping)) {
    return "the formulation gaussian supports one wall with constant damping, or no wall";
  }
  if (features.no_wall && equation_of(options) == Equation::kf) {
    return "the jump integral of the formulation gaussian needs a wall: use equation km4 or white";
  }
  return objection_at_walls(features);
}

}  // namespace

std::string objection(const problem::Problem& problem, const Options& options) {
  const problem::Features features = problem::features(problem);
  if (features.original) return "";
  switch (options.formulation) {
    case Formulation::gaussian:
      return objection_of_gaussian(features, options);
    case Formulation::moment:
      return objection_at_walls(features);
    case Formulation::polar:
      if (contact::applies(problem)) return "";
      return features.rests_in_contact
                 ? "with an atom, the formulation polar needs one wall against which the force "
                   "presses everywhere; use fd or mcs"
                 : "the formulation polar needs one wall at the equilibrium, constant damping and "
                   "impulses alone";
  }
  return "";
}

}  // namespace fpkcheck::epc
