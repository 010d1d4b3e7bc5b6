#pragma once

#include <array>

#include "methods/method_interface.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

// Registry entries of the built-in solvers, each defined in a file of methods/ with the name of the
// solver.
Solver epc_solver();
Solver fd_solver();
Solver mcs_solver();
Solver linearisation_solver();
Solver averaging_solver();
Solver cumulant_solver();
Solver path_integration_solver();

/// The built-in solvers in the order of help texts and lists. Among solvers of the density equation
/// the order is by increasing trust.
inline constexpr std::array kBuiltinSolvers = {
    epc_solver,           path_integration_solver, fd_solver,      mcs_solver,
    linearisation_solver, averaging_solver,        cumulant_solver};

/// Returns a registry of all built-in solvers.
SolverRegistry builtin_registry();

}  // namespace fpkcheck::methods
