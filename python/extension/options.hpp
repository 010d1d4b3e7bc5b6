#pragma once

#include <string>
#include <vector>

#include "base/options/parameter_value.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::python {

/// Selects methods by a comma-separated list, and sets their options to values from Python.
/// @param options values of options by key: "SOLVER.NAME", or "NAME" for all solvers with this
/// option
/// @throws InputError of SolverRegistry::methods_selected_by_list(); also for an option that no
/// solver has, a value of the wrong type or out of range, or options that belong to another method
std::vector<methods::Method> methods_selected_by_list(const methods::SolverRegistry& registry,
                                                      const std::string& list,
                                                      const base::Values& options);

}  // namespace fpkcheck::python
