#pragma once

#include <span>
#include <string>
#include <vector>

#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// Solutions that others found, as methods that solve nothing: their marginals are read here, once,
/// and put on the comparison axes of the case. Files of the same label make one solution, with
/// method "file", of which neither equation nor impact is known, and the moments that its
/// marginals give.
/// @param arguments each FILE or FILE:LABEL; without a label, the file's stem
/// @param registry whose ids no label may have
/// @return in the order in which the labels come first
/// @throws InputError on one line: a file (GivenMarginal), a label that is no id or a method's,
///         two files of one label and variable
std::vector<Method> given_methods(std::span<const std::string> arguments, const Registry& registry);

}  // namespace fpkcheck::methods
