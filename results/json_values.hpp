#pragma once

#include <string>

#include "problem/problem.hpp"
#include "transform/metric.hpp"

namespace fpkcheck::results {

/// True for a text of summary_text: an object with a schema.
/// @param where the file's name in messages
/// @throws InputError on one line where the text is not JSON
bool is_summary(const std::string& text, const std::string& where);

/// The values of an external JSON object as metrics, by their paths, such as "coefficients[2].a".
/// @throws InputError on one line: not JSON, no object
transform::Metrics values_in_json(const std::string& text, const std::string& where);

}  // namespace fpkcheck::results
