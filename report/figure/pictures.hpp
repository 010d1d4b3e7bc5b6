#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Removes the pictures and scripts that draw_pictures made for the cases of a run.
void remove_pictures(const std::filesystem::path& directory, const results::Run& run);

/// Draws every case into DIRECTORY/figures: NAME.png or other formats, and the script NAME.gp that
/// draws them, with NAME = results::file_stem of the case. Likewise NAME-budget with an error
/// budget, NAME-sources with error sources, and NAME-order with several orders of a family. Earlier
/// pictures of a case are removed, so that a case that cannot be drawn has none.
/// @param gnuplot name or path of the program
/// @param others  pictures drawn after those of the cases
/// @return warnings about pictures that could not be drawn, one line each
/// @throws std::runtime_error if a script cannot be written
std::vector<std::string> draw_pictures(const std::filesystem::path& directory,
                                       const results::Run& run, const FigureOptions& options = {},
                                       const std::string& gnuplot = "gnuplot",
                                       const std::vector<Picture>& others = {});

}  // namespace fpkcheck::report
