#include "epc/offered.hpp"

#include "problem/features.hpp"

namespace fpkcheck::epc {

std::string objection(const problem::Problem& problem, const Options&) {
  if (problem::features(problem).original) return "";
  return "it treats one wall at the equilibrium, constant damping and impulses alone";
}

}  // namespace fpkcheck::epc
