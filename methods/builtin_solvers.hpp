#pragma once

#include "methods/method_interface.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// Registry entries of the built-in solvers, defined in methods/epc.cpp, methods/fd.cpp and
/// methods/mcs.cpp.
Solver epc_solver();
Solver fd_solver();
Solver mcs_solver();

SolverRegistry builtin_registry();

}  // namespace fpkcheck::methods
