#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Removes the pictures and gnuplot scripts that draw_pictures_of_cases() wrote for the cases of a run.
void remove_pictures_of_cases(const std::filesystem::path& directory, const results::Run& run);

/// Draws the pictures of every case. The directory DIRECTORY/figures receives the gnuplot script
/// NAME.gp and its picture NAME.png (or another format), with NAME = results::case_file_stem of the
/// case. Further pictures are NAME-budget for an error budget, NAME-sources for error sources, and
/// NAME-order for closures of several orders. Earlier pictures of each case are removed first, so
/// that no outdated picture remains after a failure.
/// @param gnuplot name or path of the program
/// @param additional_pictures additional pictures, drawn after the pictures of the cases
/// @return warnings about pictures that could not be drawn, one line each
/// @throws std::runtime_error if a script cannot be written
std::vector<std::string> draw_pictures_of_cases(
    const std::filesystem::path& directory, const results::Run& run,
    const FigureOptions& options = {}, const std::string& gnuplot = "gnuplot",
    const std::vector<PictureScript>& additional_pictures = {});

}  // namespace fpkcheck::report
