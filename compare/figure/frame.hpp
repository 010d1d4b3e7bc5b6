#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// What all pictures share.
namespace fpkcheck::compare {

/// In pixels.
struct FigureSize {
  int width;
  int height;
};

/// The first lines of a gnuplot script: it draws FILE_STEM.png or, with format='svg',
/// FILE_STEM.svg; the gnuplot variable `target` names another file.
std::string figure_output(const std::string& file_stem, const FigureSize& size);

/// A case's name and parameters, as a gnuplot string.
/// @param summary_case one element of "cases" in summary.json
std::string figure_title(const nlohmann::ordered_json& summary_case);

}  // namespace fpkcheck::compare
