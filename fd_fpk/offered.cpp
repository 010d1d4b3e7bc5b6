#include "fd_fpk/offered.hpp"

#include "problem/features.hpp"

namespace fpkcheck::fd_fpk {

std::string objection(const problem::Problem& problem, const Options&) {
  if (problem::features(problem).original) return "";
  return "it treats one wall at the equilibrium, constant damping and impulses alone";
}

}  // namespace fpkcheck::fd_fpk
