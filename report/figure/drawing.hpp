#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/figure/options.hpp"

namespace fpkcheck::report {

/// Exception: the program gnuplot was not found.
struct GnuplotMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs gnuplot to draw the picture of a script. The extension of `picture` determines the format.
/// The picture file is either replaced completely or left unchanged. The same holds for the
/// graphics file STEM-tex.pdf, which STEM.tex includes.
/// @throws GnuplotMissing
/// @throws std::runtime_error with a message of one line if gnuplot drew no picture
void draw_picture(const std::string& gnuplot, const std::filesystem::path& script,
                  const std::filesystem::path& picture, FigureWidth width = FigureWidth::screen);

/// Runs gnuplot on each script STEM.gp once for each file format in the figure options, in several
/// processes at once. The pictures are written to the directory of the scripts.
/// @return a warning for each picture that was not drawn; empty after a stop request
/// @throws GnuplotMissing
std::vector<std::string> draw_scripts_in_all_formats(const std::string& gnuplot,
                                                     const std::filesystem::path& figures,
                                                     const std::vector<std::string>& stems,
                                                     const FigureOptions& options);

/// Writes the script STEM.gp into a directory, and draws its pictures in each file format of the
/// figure options.
/// @return a warning for each picture that was not drawn; a single warning if gnuplot is missing
std::vector<std::string> write_script_and_draw(const std::filesystem::path& figures,
                                               const std::string& stem, const std::string& script,
                                               const FigureOptions& options,
                                               const std::string& gnuplot);

void remove_script_and_pictures(const std::filesystem::path& figures, const std::string& stem);

}  // namespace fpkcheck::report
