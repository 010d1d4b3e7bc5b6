#pragma once

#include "methods/registry.hpp"
#include "methods/solver.hpp"

namespace fpkcheck::methods {

/// The registry entries of this project's solvers, each in a file of its name.
Solver epc_solver();
Solver fd_solver();
Solver mcs_solver();

/// The registry of all these solvers.
Registry builtin_registry();

}  // namespace fpkcheck::methods
