#pragma once

#include <nlohmann/json_fwd.hpp>

#include <exception>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>

#include "base/options/parameter_value.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"
#include "transform/solution.hpp"
#include "transform/solver_metric.hpp"

/// Conversions between JSON and the data of a run, for all JSON files of the results of a run.

namespace fpkcheck::results {

using Json = nlohmann::ordered_json;

/// Returns a JSON object with the name, version and command line of the program. Every JSON file of
/// the results of a run begins with the object that program_to_json() returns.
Json program_to_json(const ProgramInfo& program);
/// Returns a JSON object with the name and the case-file sections of a problem, such as "system"
/// and "impulse".
Json problem_to_json(const problem::Problem& problem);
Json value_to_json(const base::Value& value);
Json values_to_json(const base::Values& values);
Json moments_to_json(const transform::Moments& moments);
Json number_or_null_json(const std::optional<double>& number);

/// Adds metrics to a JSON object. A metric path such as "quantiles.y[2].value" creates the nested
/// objects and lists. A metric path that ends with "[]", such as "splitting_thresholds[]", creates
/// an empty list.
/// @throws std::logic_error if a part of a path is already a number or a text, or if two metrics
///         have the same path
void add_metrics(const transform::Metrics& metrics, Json& object);
/// Reads the metrics from a JSON object that add_metrics() wrote. Each number or text in the JSON
/// object is one metric, of kind `text` for a string and of kind `result` for other values.
transform::Metrics metrics_from_json(const Json& object);

/// @throws InputError if the JSON value is a list, an object or an integer out of range
base::Value value_from_json(const Json& json);
/// @throws nlohmann::json::exception, InputError
base::Values values_from_json(const Json& object);
/// @throws nlohmann::json::exception, InputError
problem::Problem problem_from_json(const Json& object);
/// Number that represents the JSON value null, since JSON has no NaN.
inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
/// Returns the number under a key of a JSON object, or NaN if the JSON value is null.
/// @throws nlohmann::json::exception
double number_at_key(const Json& object, const char* key);
/// @throws nlohmann::json::exception
transform::Moments moments_from_json(const Json& json);
/// Returns the integer under a key of a JSON object.
/// @throws nlohmann::json::exception
/// @throws InputError if the JSON value is not an integer in the range of int
int integer_at_key(const Json& object, const char* key);
/// Returns the number under a key of a JSON object, or nothing if the key is missing or the JSON
/// value is null.
/// @throws nlohmann::json::exception
std::optional<double> optional_number_at_key(const Json& object, const char* key);

/// Returns a copy of a JSON value with null for each infinity and NaN, which JSON lacks.
Json replace_non_finite_by_null(Json value);

/// Returns the text of a JSON value. Bytes that are not valid UTF-8, for example from file names,
/// become the replacement character U+FFFD.
std::string serialise_json(const Json& json);

/// Parses the JSON text of a file. The JSON parser limits the nesting depth, the number of values
/// and the length of texts.
/// @param file_name name of the file, for messages
/// @throws InputError with a message of one line
Json parse_json(std::istream& in, const std::string& file_name);

/// Removes a prefix such as "[json.exception.out_of_range.403] " from the message of an exception.
std::string json_error_message(const std::exception& error);

/// Returns whether a JSON text is the summary of a run: a JSON object with the key "schema".
/// @param file_name name of the file, for messages
/// @throws InputError with a message of one line, if the text is not JSON
bool is_run_summary(const std::string& text, const std::string& file_name);

/// Reads the values in a JSON file of another program as metrics. The path of a value in the JSON
/// file, such as "coefficients[2].a", becomes the path of the metric.
/// @param file_name name of the file, for messages
/// @throws InputError with a message of one line, if the text is not a JSON object
transform::Metrics metrics_from_external_json(const std::string& text,
                                              const std::string& file_name);

/// Returns a solution as an element of "solutions" in summary.json: the keys that all solutions
/// have, then the metrics of the solver.
/// @throws std::logic_error if a metric has the name of a key that all solutions have
Json solution_json(const transform::Solution& solution);

/// Converts a JSON object from solution_json() back to a solution, without the density.
/// @throws nlohmann::json::exception, InputError
transform::Solution solution_from_json(const Json& json);

}  // namespace fpkcheck::results
