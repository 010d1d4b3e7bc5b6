#pragma once

#include <string>

#include "epc/newton.hpp"
#include "epc/projection.hpp"
#include "epc/solve.hpp"

namespace fpkcheck::epc {

/// What the search for a root of (23) came to.
struct Search {
  NewtonResult root;
  std::string failure;  ///< one sentence when no root was found
};

/// Plain Newton steps from equivalent linearisation, as in the paper; where they are lost, the
/// branch of solutions from the exact density without impact losses.
Search find_root(const Projection& projection, const ResidualCoefficients& f,
                 const Options& options);

}  // namespace fpkcheck::epc
