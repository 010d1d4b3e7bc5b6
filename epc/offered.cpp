#include "epc/offered.hpp"

#include "epc/contact/coordinates.hpp"
#include "problem/features.hpp"

namespace fpkcheck::epc {

namespace {

std::string objection_at_walls(const problem::Features& features) {
  if (features.rests_in_contact) {
    return "the mass comes to rest at a wall, with a probability of its own, which no exponential "
           "polynomial of y and y' has";
  }
  if (features.collapse) {
    return "under noise impacts accumulate where a restitution is <= exp(-pi / sqrt 3), and the "
           "density at the wall is no exponential polynomial";
  }
  return "";
}

std::string objection_of_gaussian(const problem::Features& features, const Options& options) {
  if (features.two_walls || (!features.no_wall && !features.constant_damping)) {
    return "its plane is folded at one wall, with constant damping, or has no wall at all";
  }
  if (features.no_wall && equation_of(options) == Equation::kf) {
    return "its jump integral is that of the plane folded at a wall";
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
                 ? "its amplitudes are those about one wall that the force presses on from everywhere"
                 : "its phases are those of one wall at the equilibrium, constant damping and "
                   "impulses alone";
  }
  return "";
}

}  // namespace fpkcheck::epc
