#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/figure/options.hpp"

namespace fpkcheck::report {

/// gnuplot was not found. The handler's warning states how to draw later.
struct GnuplotMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs gnuplot to draw the picture of a script, in the format given by the extension of `picture`.
/// The file is replaced as a whole or left unchanged, as is STEM-tex.pdf, which STEM.tex includes.
/// @throws GnuplotMissing
/// @throws std::runtime_error with a one-line message if gnuplot drew nothing
void draw(const std::string& gnuplot, const std::filesystem::path& script,
          const std::filesystem::path& picture, FigureWidth width = FigureWidth::screen);

/// Draws STEM.gp in all formats of the options, in the directory of the script.
/// @return a warning for each picture that was not drawn
/// @throws GnuplotMissing
std::vector<std::string> draw_formats(const std::string& gnuplot,
                                      const std::filesystem::path& figures, const std::string& stem,
                                      const FigureOptions& options);

/// Writes STEM.gp into a directory and draws it in all formats of the options.
/// @return a warning for each picture that was not drawn; a single warning without gnuplot
std::vector<std::string> write_pictures(const std::filesystem::path& figures,
                                        const std::string& stem, const std::string& script,
                                        const FigureOptions& options, const std::string& gnuplot);

/// Removes STEM.gp and its pictures in all formats from a directory, if present.
void remove_pictures_of(const std::filesystem::path& figures, const std::string& stem);

}  // namespace fpkcheck::report
