#pragma once

#include <string>

#include "problem/problem.hpp"

/// What all pictures share.
namespace fpkcheck::report {

/// In pixels.
struct FigureSize {
  int width;
  int height;
};

/// The first lines of a gnuplot script: it draws FILE_STEM.png or, with format='svg',
/// FILE_STEM.svg, and refuses other formats; the gnuplot variable `target` names another file.
std::string figure_output(const std::string& file_stem, const FigureSize& size);

/// A case's name and parameters, as a gnuplot string.
std::string figure_title(const problem::Problem& problem);

}  // namespace fpkcheck::report
