#pragma once

#include <span>
#include <string>

#include "methods/method_interface.hpp"
#include "methods/registry.hpp"

namespace fpkcheck::methods {

/// @param registry methods whose ids are not available as labels
/// @throws InputError with a message of one line, if the label is not a valid id, or is the id of a
///         method
void require_valid_label(const std::string& label, const SolverRegistry& registry);

/// Checks that two labels differ after the replacement of '-' and '.' by '_'. The names of netCDF
/// variables and gnuplot data blocks cannot contain the characters '-' and '.' of labels.
/// @throws InputError with a message of one line
void require_distinct_labels(const std::string& one, const std::string& other);

/// Groups external densities of several closure orders into families of at least two members. The
/// label of a member is the family name followed by the order: "chi-n2", "chi2" or "chi_2" for
/// order 2. The members of a family of external densities have the same colour and different dash
/// patterns.
/// @param methods external densities from files, functions or samples
void group_methods_into_families(std::span<Method> methods);

}  // namespace fpkcheck::methods
