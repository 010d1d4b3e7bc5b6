#pragma once

#include <span>
#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// Solutions that others found, as methods that solve nothing: their files are read here, once, and
/// put on the comparison axes of the case. A file holds a marginal density (GivenMarginal), a
/// joint density on a grid (GivenJoint) or as a closed form (epc::ClosedForm); files of
/// marginals with the same label make one solution, and several orders a family
/// (methods/external/families.hpp). Their method is "file". Where an equation
/// is said, by the argument or by the file, they are closures; otherwise neither equation nor
/// impact is known.
/// @param arguments each as GivenArgument has it
/// @param registry whose ids no label may have
/// @param case_name the case that is meant in a file of several
/// @return in the order in which the labels come first
/// @throws InputError on one line: an argument, a file, a label that is no id or a method's, two
///         files of one label and variable
std::vector<Method> given_methods(std::span<const std::string> arguments, const Registry& registry,
                                  const std::string& case_name = {});

}  // namespace fpkcheck::methods
