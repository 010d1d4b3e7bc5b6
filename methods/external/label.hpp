#pragma once

#include <string>

#include "methods/registry.hpp"

/// Requirements on the labels of external densities.
namespace fpkcheck::methods {

/// @param registry whose ids no label may have
/// @throws InputError on one line when the label is not a valid id, or is the id of a method
void require_valid_label(const std::string& label, const Registry& registry);

/// @throws InputError on one line when the labels differ only in '-', '_' or '.', which names of
///         variables and data blocks cannot contain
void require_distinct_labels(const std::string& one, const std::string& other);

}  // namespace fpkcheck::methods
