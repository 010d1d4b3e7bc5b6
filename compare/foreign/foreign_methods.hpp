#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/methods.hpp"

namespace fpkcheck::compare {

/// Solutions that others found, as methods that solve nothing: their marginals are read here, once,
/// and put on the comparison axes of the case. Files of the same label make one solution, with
/// method "file", equation "given", an unknown impact, and the moments that its marginals give.
/// @param arguments each FILE or FILE:LABEL; without a label, the file's stem
/// @return in the order in which the labels come first
/// @throws InputError on one line: a file (ForeignMarginal), a label that is no id or a method's,
///         two files of one label and variable
std::vector<Method> foreign_methods(std::span<const std::string> arguments);

}  // namespace fpkcheck::compare
