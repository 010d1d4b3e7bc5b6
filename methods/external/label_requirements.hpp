#pragma once

#include <string>

#include "methods/registry.hpp"

/// Requirements on the labels of external densities.
namespace fpkcheck::methods {

/// Tests the label of an external density.
/// @param registry registry of methods; no label may be the id of a method
/// @throws InputError with a message of one line, if the label is not a valid id, or is the id of a
///         method
void require_valid_label(const std::string& label, const Registry& registry);

/// Tests that two labels of external densities remain different if '_' replaces '-' and '.'. Names
/// of netCDF variables and of gnuplot data blocks cannot contain '-' and '.'.
/// @throws InputError with a message of one line, if the labels differ only in '-', '_' or '.'
void require_distinct_labels(const std::string& one, const std::string& other);

}  // namespace fpkcheck::methods
