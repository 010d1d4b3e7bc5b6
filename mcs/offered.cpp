#include "mcs/offered.hpp"

#include "problem/features.hpp"
#include "problem/inelastic_collapse.hpp"

namespace fpkcheck::mcs {

std::string objection(const problem::Problem& problem, const Options& options) {
  if (problem::of_the_paper(problem)) return "";
  if (options.tails) {
    return "splitting for the tails takes one wall at the equilibrium, constant damping and impulses "
           "alone";
  }
  return problem::collapse_objection(problem, options.equation);
}

}  // namespace fpkcheck::mcs
