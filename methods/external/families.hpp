#pragma once

#include <span>

#include "methods/method.hpp"

namespace fpkcheck::methods {

/// Densities that somebody brought along make a family where they differ by their order: at least two
/// whose labels are one name and their orders, "chi-n2" (or "chi2", "chi_4", ..) of order 2. The name
/// is their family's, in tables, pictures and the verdict; they have one colour, and dashes by order.
/// @param guests as given_methods, own_function and own_samples made them
void join_families(std::span<Method> guests);

}  // namespace fpkcheck::methods
