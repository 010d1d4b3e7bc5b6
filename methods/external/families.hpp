#pragma once

#include <span>

#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Groups external densities of several closure orders into families. A family has at least two
/// densities. The labels of its members are a common name followed by the order: "chi-n2", "chi2"
/// or "chi_2" for order 2. The common name is the name of the family in tables, figures and the
/// verdict. The members of a family have the same colour, and different dash patterns by order.
/// @param methods external densities, from external_methods(), make_method_from_density_values()
///        and make_method_from_samples()
void group_families(std::span<Method> methods);

}  // namespace fpkcheck::methods
