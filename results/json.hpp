#pragma once

#include <nlohmann/json_fwd.hpp>

#include <exception>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "base/options/parameter.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"
#include "transform/metric.hpp"

/// Functions that the writers and readers of all JSON files of results share.
namespace fpkcheck::results {

using Json = nlohmann::ordered_json;

/// A JSON object with the name, version and command line of the program. Every file of results
/// begins with this object.
Json program_json(const Program& program);
/// A JSON object with the name of a case and its sections "system" and "impulse".
Json problem_json(const problem::Problem& problem);
/// The JSON value of an option or parameter.
Json value_json(const base::Value& value);
/// A JSON object with one field for each named value.
Json values_json(const base::Values& values);
/// A JSON object with the moments by name: "y1", "y2", ..
Json moments_json(const transform::Moments& moments);

/// Adds metrics to a JSON object. A path such as "quantiles.y[2].value" creates the objects and
/// lists along the path; the path "splitting_thresholds[]" creates an empty list.
/// @throws std::logic_error when a part of a path is already a number or a text, or when two
///         metrics have the same path
void add_metrics(const transform::Metrics& metrics, Json& object);
/// Reads the metrics that add_metrics() wrote: one metric for each leaf of the JSON object. The
/// kind of a metric follows from the type of the leaf: `text` for a string, otherwise `result`.
transform::Metrics metrics_from_json(const Json& object);

/// Converts the result of value_json() back to a value.
/// @throws InputError when the JSON value is a list, an object or an integer out of range
base::Value value_from_json(const Json& json);
/// Converts the result of values_json() back to named values.
/// @throws nlohmann::json::exception, InputError
base::Values values_from_json(const Json& object);
/// Converts the result of problem_json() back to a problem.
/// @throws nlohmann::json::exception, InputError
problem::Problem problem_from_json(const Json& object);
/// The number that represents null when JSON is read, since JSON has no NaN.
inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
/// The number under a key of a JSON object; NaN if the JSON value is null.
/// @throws nlohmann::json::exception
double number_in(const Json& object, const char* key);
/// Converts the result of moments_json() back to moments.
/// @throws nlohmann::json::exception
transform::Moments moments_from_json(const Json& json);
/// The integer under a key of a JSON object.
/// @throws nlohmann::json::exception
/// @throws InputError when the JSON value is not an integer, or is out of the range of int
int integer_in(const Json& object, const char* key);
/// The number under a key of a JSON object; empty if the key is missing or its value is null.
/// @throws nlohmann::json::exception
std::optional<double> optional_number_in(const Json& object, const char* key);

/// A copy of a JSON value in which null replaces every number that is not finite, since JSON has
/// neither infinities nor NaN.
Json with_null_for_non_finite(Json value);

/// The text of a JSON value. The text has replacement characters in place of bytes that are not
/// UTF-8, since file names may contain such bytes.
std::string json_text(const Json& json);

/// Parses the JSON of a file. The depth of nesting, the number of values and the length of texts
/// are limited.
/// @param where name of the file, for messages
/// @throws InputError with a message of one line
Json parse_json(std::istream& in, const std::string& where);

/// The message of a JSON exception, without a prefix such as "[json.exception.out_of_range.403] ".
std::string exception_text(const std::exception& error);

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
