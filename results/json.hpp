#pragma once

#include <exception>
#include <iosfwd>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/options/value.hpp"
#include "problem/problem.hpp"
#include "results/run.hpp"
#include "transform/metric.hpp"

/// Common parts of the JSON files of results, for their writers and readers only.
namespace fpkcheck::results {

using Json = nlohmann::ordered_json;

/// The name, version and command line of the program: the first object of every file of results.
Json program_json(const Program& program);
/// A case's name and its sections "system" and "impulse".
Json problem_json(const problem::Problem& problem);
Json value_json(const base::Value& value);
/// An object with a field per value.
Json values_json(const base::Values& values);
Json moments_json(const transform::Moments& moments);

/// Adds metrics to an object. A path such as "quantiles.y[2].value" creates the objects and lists
/// along it; the path "splitting_thresholds[]" creates an empty list.
/// @throws std::logic_error when a path leads through a value, or two metrics have the same path
void add_metrics(const transform::Metrics& metrics, Json& object);
/// The metrics in an object, as add_metrics wrote them: one for each leaf. The kind follows from
/// the type of the leaf: `text` for a string, otherwise `result`.
transform::Metrics metrics_in(const Json& object);

/// Conversions from JSON.
/// @throws nlohmann::json::exception, InputError
base::Value value_in(const Json& json);
base::Values values_in(const Json& object);
problem::Problem problem_in(const Json& object);
/// The value for null in place of a number, since JSON has no NaN.
inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
/// NaN for null.
double number_in(const Json& object, const char* key);
transform::Moments moments_in(const Json& json);
/// @throws nlohmann::json::exception; InputError where the value is no integer or out of the range
///         of int
int integer_in(const Json& object, const char* key);
/// No value where the field is missing or null.
std::optional<double> optional_number_in(const Json& object, const char* key);

/// Replaces numbers that are not finite by null, since JSON has no infinities.
Json with_null_for_non_finite(Json value);

/// The JSON as text. Replaces bytes that are not UTF-8, which file names may contain.
std::string text_of(const Json& json);

/// Parses a file's JSON, with limits on depth, number of values and length of texts.
/// @param where the file's name in messages
/// @throws InputError on one line
Json parse_json(std::istream& in, const std::string& where);

/// The text of a JSON exception without its prefix, such as "[json.exception.out_of_range.403] ".
std::string exception_text(const std::exception& error);

}  // namespace fpkcheck::results
