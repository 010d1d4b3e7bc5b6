#pragma once

#include <span>

#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Groups external densities of several orders into families. A family has at least two densities
/// whose labels are a common name followed by the order: "chi-n2", "chi2" or "chi_2" for order 2.
/// The common name is the family's name in tables, figures and the verdict. Its members have one
/// colour, and dashes by order.
/// @param methods from external_methods, make_function_method and make_samples_method
void group_families(std::span<Method> methods);

}  // namespace fpkcheck::methods
