#pragma once

#include <string>
#include <vector>

#include "base/options/value.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::python {

/// The methods of a list, with options replaced.
/// @param list as Registry::select takes it
/// @param options by "SOLVER.NAME", or by "NAME" of all solvers that have one
/// @throws InputError as Registry::select; for an option that no solver has, that is not of its
///         type or out of its range, or that makes the method another one
std::vector<methods::Method> methods_with(const methods::Registry& registry,
                                          const std::string& list, const base::Values& options);

}  // namespace fpkcheck::python
