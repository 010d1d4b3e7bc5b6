#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/figure/options.hpp"

namespace fpkcheck::report {

/// There is no gnuplot to draw with; whoever catches it says how to draw later.
struct GnuplotMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Lets gnuplot draw a script's picture; its format is the extension of `picture`. The file is
/// either whole or as it was; so is STEM-tex.pdf, which a STEM.tex includes.
/// @throws GnuplotMissing; std::runtime_error on one line when nothing was drawn
void draw(const std::string& gnuplot, const std::filesystem::path& script,
          const std::filesystem::path& picture, FigureWidth width = FigureWidth::screen);

/// Draws STEM.png and what else is asked for from STEM.gp beside them.
/// @return a warning for each picture that was not drawn
/// @throws GnuplotMissing
std::vector<std::string> draw_all(const std::string& gnuplot, const std::filesystem::path& figures,
                                  const std::string& stem, const FigureOptions& options);

/// Writes STEM.gp into a directory and draws the pictures that are asked for from it.
/// @return a warning for each picture that was not drawn; one when there is no gnuplot
std::vector<std::string> write_pictures(const std::filesystem::path& figures,
                                        const std::string& stem, const std::string& script,
                                        const FigureOptions& options, const std::string& gnuplot);

/// Removes STEM.gp and its pictures in all formats in a directory, where they are.
void remove_pictures_of(const std::filesystem::path& figures, const std::string& stem);

}  // namespace fpkcheck::report
