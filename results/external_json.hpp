#pragma once

#include <string>

#include "problem/problem.hpp"
#include "transform/metric.hpp"

namespace fpkcheck::results {

/// Whether a JSON text is the summary of a run (summary_text): an object with the key "schema".
/// @param where name of the file, for messages
/// @throws InputError with a message of one line, if the text is not JSON
bool is_run_summary(const std::string& text, const std::string& where);

/// Reads an external JSON object as metrics. The name of a metric is the path of its value, such as
/// "coefficients[2].a".
/// @param where name of the file, for messages
/// @throws InputError with a message of one line, if the text is not JSON or not an object
transform::Metrics metrics_from_external_json(const std::string& text, const std::string& where);

}  // namespace fpkcheck::results
