#pragma once

#include "methods/method.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// The registry entries of the solvers of this project. Each entry is defined in the file of its
/// name: methods/epc.cpp, methods/fd.cpp, methods/mcs.cpp.
Solver epc_solver();
Solver fd_solver();
Solver mcs_solver();

/// A registry with all solvers of this project.
Registry builtin_registry();

}  // namespace fpkcheck::methods
