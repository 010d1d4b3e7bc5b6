#pragma once

#include "methods/method_interface.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// Registry entries of the built-in solvers, each defined in a file of methods/ with the name of
/// the solver.
Solver epc_solver();
Solver fd_solver();
Solver linearisation_solver();
Solver averaging_solver();
Solver mcs_solver();

SolverRegistry builtin_registry();

}  // namespace fpkcheck::methods
