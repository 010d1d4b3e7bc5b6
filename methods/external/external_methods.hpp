#pragma once

#include <span>
#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// Reads external densities from files and returns methods whose solutions are the external
/// densities. Each density file contains a marginal density (ExternalMarginal), a joint density on
/// a grid (JointTable) or a joint density as a closed form (epc::ClosedFormDensity). Two marginal
/// densities with the same label form one solution. External densities of several closure orders
/// form a family (methods/external/external_labels.hpp). The solver of all methods for external
/// densities from files has the name "file". An external density has the role of a closure if the
/// argument or the file states a density equation; otherwise the density equation and the impact
/// condition are unknown.
/// @param registry methods whose ids are not available as labels
/// @param case_name name of the case to use in a density file with several cases
/// @return one method for each label, in the order of first occurrence of the labels
/// @throws InputError with a message of one line, for an invalid argument, file or label, and for
///         two files with the same label and variable
std::vector<Method> external_density_methods_from_files(std::span<const std::string> arguments,
                                                        const SolverRegistry& registry,
                                                        const std::string& case_name = {});

}  // namespace fpkcheck::methods
