#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "compare/marginals_csv.hpp"

namespace fpkcheck::compare {

/// The name, without extension, under which a case's pictures are filed.
std::string picture_stem(std::string case_name);

/// The name under which its error budget is filed.
std::string budget_stem(const std::string& picture_stem);

/// Removes what draw_pictures made of the cases of a summary.
void remove_pictures(const std::filesystem::path& directory, const nlohmann::ordered_json& summary);

/// Draws every case into DIRECTORY/figures: NAME.png, NAME.svg and the script NAME.gp that drew
/// them and can draw them again; NAME-budget likewise where there is an error budget. From what a
/// run has saved alone. A case that cannot be drawn has no pictures afterwards.
/// @param gnuplot the program that draws
/// @return warnings, one line each: pictures that could not be drawn, and why
/// @throws std::runtime_error when a script cannot be written
std::vector<std::string> draw_pictures(const std::filesystem::path& directory,
                                       const nlohmann::ordered_json& summary,
                                       std::span<const MarginalCurve> curves,
                                       const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::compare
