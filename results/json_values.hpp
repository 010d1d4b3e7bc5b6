#pragma once

#include <string>

#include "problem/problem.hpp"
#include "transform/metric.hpp"

namespace fpkcheck::results {

/// True for what summary_text wrote: it has a schema.
/// @param where how messages name the file
/// @throws InputError on one line where it is not JSON
bool is_summary(const std::string& text, const std::string& where);

/// An object of somebody else's: its values by their paths, "coefficients[2].a".
/// @throws InputError on one line: not JSON, no object
transform::Metrics values_in_json(const std::string& text, const std::string& where);

}  // namespace fpkcheck::results
