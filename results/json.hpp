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

/// The parts that every JSON file of results is made of, for its writer and its reader alone.
namespace fpkcheck::results {

using Json = nlohmann::ordered_json;

/// The name and version of the program, and its command line: what every file of results opens
/// with.
Json program_json(const Program& program);
/// A case's name and its sections: "system", "impulse".
Json problem_json(const problem::Problem& problem);
Json value_json(const base::Value& value);
/// An object with a field per value.
Json values_json(const base::Values& values);
Json moments_json(const transform::Moments& moments);

/// Adds metrics to an object: a path such as "quantiles.y[2].value" makes the objects and
/// lists on its way, "splitting_thresholds[]" without a value an empty list.
/// @throws std::logic_error when a path leads through a value
void add_observations(const transform::Metrics& metrics, Json& object);
/// The metrics that add_observations made of an object: each leaf, with the kind that its form
/// tells (a number or a flag: result; else text).
transform::Metrics observations_in(const Json& object);

/// @throws nlohmann::json::exception, InputError
base::Value value_in(const Json& json);
base::Values values_in(const Json& object);
problem::Problem problem_in(const Json& object);
/// What stands for a number that JSON cannot have.
inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
/// NaN for null.
double number_in(const Json& object, const char* key);
transform::Moments moments_in(const Json& json);
/// @throws nlohmann::json::exception, InputError where it is no whole number or one that no int holds
int integer_in(const Json& object, const char* key);
/// None where the field is missing or null.
std::optional<double> number_if_any(const Json& object, const char* key);

/// JSON has no infinities: numbers that are not finite become null.
Json with_null_for_non_finite(Json value);

/// As text. Bytes that are not UTF-8 (a file's name may have any) are replaced.
std::string text_of(const Json& json);

/// A file's JSON, nested no deeper than any of ours.
/// @param where how messages name it
/// @throws InputError on one line
Json parsed(std::istream& in, const std::string& where);

/// What is wrong with a file, without the prefix "[json.exception.out_of_range.403] ", which
/// tells the reader nothing.
std::string said_by(const std::exception& error);

}  // namespace fpkcheck::results
