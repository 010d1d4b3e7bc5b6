#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/figure/figure_options.hpp"

namespace fpkcheck::report {

struct GnuplotNotFound : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Draws the picture of a gnuplot script by the program gnuplot. The file extension of `picture`
/// determines the picture format. The picture file is either replaced completely or left unchanged.
/// The graphics file STEM-tex.pdf, which STEM.tex includes, is also either replaced completely or
/// left unchanged.
/// @throws GnuplotNotFound
/// @throws std::runtime_error with a message of one line if gnuplot drew no picture
void draw_picture(const std::string& gnuplot, const std::filesystem::path& script,
                  const std::filesystem::path& picture, FigureWidth width = FigureWidth::screen);

/// A gnuplot script. The gnuplot script and its pictures have file names that consist of `stem` and
/// an extension.
struct PictureGnuplotScript {
  std::string stem, script;
};

/// Writes the script STEM.gp of each picture into a directory, and draws the pictures in each file
/// format of the figure options, in several processes at once.
/// @param subject, remedy first and last words of the warning if gnuplot is missing
/// @return a warning for each picture that was not drawn; a single warning if gnuplot is missing;
///         empty after a stop request
std::vector<std::string> write_scripts_and_draw(const std::filesystem::path& figures,
                                                const std::vector<PictureGnuplotScript>& pictures,
                                                const FigureOptions& options,
                                                const std::string& gnuplot,
                                                const std::string& subject,
                                                const std::string& remedy);

/// Calls write_scripts_and_draw() for the script of a single picture.
std::vector<std::string> write_script_and_draw(const std::filesystem::path& figures,
                                               const std::string& stem, const std::string& script,
                                               const FigureOptions& options,
                                               const std::string& gnuplot);

void remove_script_and_pictures(const std::filesystem::path& figures, const std::string& stem);

}  // namespace fpkcheck::report
