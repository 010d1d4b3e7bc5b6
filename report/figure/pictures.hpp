#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Removes what draw_pictures made of the cases of a run.
void remove_pictures(const std::filesystem::path& directory, const results::Run& run);

/// Draws every case into DIRECTORY/figures: NAME.png, or in the formats that are asked for, and the
/// script NAME.gp that drew them and can draw them again, NAME being its name as results::file_stem
/// files it; NAME-budget likewise where there is an error budget, and NAME-sources where there are
/// sources of errors. A case that cannot be drawn has no pictures afterwards.
/// @param gnuplot the program that draws
/// @param others  drawn after those of the cases
/// @return warnings, one line each: pictures that could not be drawn, and why
/// @throws std::runtime_error when a script cannot be written
std::vector<std::string> draw_pictures(const std::filesystem::path& directory,
                                       const results::Run& run, const FigureOptions& options = {},
                                       const std::string& gnuplot = "gnuplot",
                                       const std::vector<Picture>& others = {});

}  // namespace fpkcheck::report
