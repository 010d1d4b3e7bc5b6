#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// The head of the page: what was solved, how, and what came out, before any details.
namespace fpkcheck::compare {

/// The system in words and formulas, and its numbers in each case.
std::string problem_html(const nlohmann::ordered_json& summary);

/// The parameters of one case in a sentence, plain text.
std::string parameters_text(const nlohmann::ordered_json& summary_case);

/// What the names of solutions, equations, impacts and columns mean.
std::string methods_html();

/// A row per case: moments, how far the two references are from each other, the closest closure.
std::string overview_table(const nlohmann::ordered_json& summary);

/// The seconds of each solution in each case.
std::string timings_table(const nlohmann::ordered_json& summary);

}  // namespace fpkcheck::compare
