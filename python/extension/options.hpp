#pragma once

#include <string>
#include <vector>

#include "base/options/value.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::python {

/// The methods of a list, with the given options.
/// @param list as in Registry::select
/// @param options with the name "SOLVER.NAME", or "NAME" for all solvers with such an option
/// @throws InputError as Registry::select; for an option that no solver has, for a value of another
///         type or out of range, for options that select another method
std::vector<methods::Method> select_methods(const methods::Registry& registry,
                                            const std::string& list, const base::Values& options);

}  // namespace fpkcheck::python
