#pragma once

#include <span>
#include <string>

#include "methods/method.hpp"
#include "methods/registry.hpp"

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

/// Groups external densities of several closure orders into families. A family has at least two
/// densities. The labels of its members are a common name followed by the order: "chi-n2", "chi2"
/// or "chi_2" for order 2. The common name is the name of the family in tables, figures and the
/// verdict. The members of a family have the same colour, and different dash patterns by order.
/// @param methods external densities, from external_methods(), make_method_from_density_values()
///        and make_method_from_samples()
void group_families(std::span<Method> methods);

}  // namespace fpkcheck::methods
