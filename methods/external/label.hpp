#pragma once

#include <string>

#include "methods/registry.hpp"

/// What solutions that others found may be called.
namespace fpkcheck::methods {

/// @param registry whose ids no label may have
/// @throws InputError on one line when the label is no id, or a method's
void require_free(const std::string& label, const Registry& registry);

/// @throws InputError on one line when they differ in '-', '_' or '.' alone, which names of
///         variables and of blocks of data do not have
void require_unlike(const std::string& one, const std::string& other);

}  // namespace fpkcheck::methods
