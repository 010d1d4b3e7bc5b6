#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fpkcheck::compare {

/// There is no gnuplot to draw with; whoever catches it says how to draw later.
struct GnuplotMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Lets gnuplot draw a script's picture; its format is the extension of `picture`. The file is
/// either whole or as it was.
/// @throws GnuplotMissing; std::runtime_error on one line when nothing was drawn
void draw(const std::string& gnuplot, const std::filesystem::path& script,
          const std::filesystem::path& picture);

/// Removes STEM.png, STEM.svg and STEM.gp in a directory, where they are.
void remove_pictures_of(const std::filesystem::path& figures, const std::string& stem);

}  // namespace fpkcheck::compare
