#include "epc/offered.hpp"

#include "problem/features.hpp"

namespace fpkcheck::epc {

namespace {

std::string objection_of_moment(const problem::Features& features) {
  if (features.rests_in_contact) {
    return "the mass comes to rest at a wall, with a probability of its own: no exponential "
           "polynomial has that";
  }
  if (features.collapse) {
    return "under noise impacts accumulate where a restitution is <= exp(-pi / sqrt 3), and the "
           "density at the wall is no exponential polynomial";
  }
  return "";
}

}  // namespace

std::string objection(const problem::Problem& problem, const Options& options) {
  const problem::Features features = problem::features(problem);
  if (features.original) return "";
  switch (options.formulation) {
    case Formulation::moment:
      return objection_of_moment(features);
    case Formulation::gaussian:
    case Formulation::polar:
      break;
  }
  return "it treats one wall at the equilibrium, constant damping and impulses alone";
}

}  // namespace fpkcheck::epc
