#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/text/format.hpp"

namespace fpkcheck::compare {

/// The terminal table, from the contents of summary.json alone: for each case a line of parameters,
/// a row per solution, the reasons of the solutions that are not ok, and what the distances say
/// (findings.hpp); in the end what the columns that are shown mean (legend.hpp).
/// Plain ASCII, a dash for what is absent.
/// @param format where the rows do not fit, the least important columns go:
///              the energy residual, then the distance to fd-kf, the seconds, the equation, the
///              moments
/// @throws nlohmann::json::exception when a field of the contract is missing
std::string table(const nlohmann::ordered_json& summary, const TextFormat& format = {});

/// The line of parameters: "case1: c = 0.1, k = 1, ...", from a case of summary.json.
std::string case_title(const nlohmann::ordered_json& summary_case);

}  // namespace fpkcheck::compare
