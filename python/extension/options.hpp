#pragma once

#include <string>
#include <vector>

#include "base/options/parameter.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::python {

/// Selects methods by a comma-separated list, and sets their options to values from Python.
/// @param list comma-separated list of methods, as in Registry::select_methods()
/// @param options values of options. The name of an option is "SOLVER.NAME", or "NAME" for all
///        solvers with an option of that name
/// @throws InputError as Registry::select_methods(); also for an option that no solver has, for a
///         value of the wrong type or out of range, and for options that belong to another method
std::vector<methods::Method> select_methods(const methods::Registry& registry,
                                            const std::string& list, const base::Values& options);

}  // namespace fpkcheck::python
