#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "transform/marginal.hpp"

/// Questions that the table and the pictures ask of a case in summary.json.
namespace fpkcheck::compare {

/// What is wrong with a summary, without the prefix "[json.exception.out_of_range.403] ", which
/// tells the reader nothing.
std::string said_by(const nlohmann::ordered_json::exception& error);

/// The number under a key; nothing where the key is missing or null.
std::optional<double> number(const nlohmann::ordered_json& object, std::string_view key);

/// The solution with this id, or null.
const nlohmann::ordered_json* find_solution(const nlohmann::ordered_json& summary_case,
                                            std::string_view id);

bool is_ok(const nlohmann::ordered_json& solution);

/// True when there is a solution with this id, and it is ok.
bool usable(const nlohmann::ordered_json& summary_case, std::string_view id);

/// The L1 distance between two solutions, whichever of them is the reference.
std::optional<double> l1_between(const nlohmann::ordered_json& summary_case, std::string_view one,
                                 std::string_view other, transform::Variable variable);

}  // namespace fpkcheck::compare
