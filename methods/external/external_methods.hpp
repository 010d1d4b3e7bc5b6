#pragma once

#include <span>
#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// External densities from files, as methods that solve nothing. This function reads each file
/// once; the methods evaluate the densities on the comparison axes of the case.
///
/// A file contains a marginal density (ExternalMarginal), or a joint density on a grid
/// (ExternalJointDensity) or as a closed form (epc::ClosedForm). Files of marginals with the same
/// label make one solution, and several orders a family (methods/external/families.hpp). The
/// solver's name is "file". A density with an equation, from the argument or the file, is a
/// closure; otherwise equation and impact are unknown.
/// @param arguments as in ExternalArgument
/// @param registry whose ids no label may have
/// @param case_name the case to use in a file with several cases
/// @return in the order of first occurrence of the labels
/// @throws InputError on one line: an invalid argument or file, a label that is invalid or a
///         method's id, two files with the same label and variable
std::vector<Method> external_methods(std::span<const std::string> arguments,
                                     const Registry& registry, const std::string& case_name = {});

}  // namespace fpkcheck::methods
