#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/figure/content.hpp"

namespace fpkcheck::compare {

/// A gnuplot script that draws one case as the paper's Figs. 2-5 do: (a) p(y), (b) its logarithm,
/// (c) p(y'), (d) its logarithm; and beside them (e), (f) the differences from the solution of the
/// full jump equation (else from the simulation), since the curves themselves nearly coincide.
/// It holds its data, and draws FILE_STEM.png or, with format='svg', FILE_STEM.svg; the gnuplot
/// variable `target` names another file.
/// @param summary_case one element of "cases" in summary.json
/// @param content with at least one side
std::string figure_script(const nlohmann::ordered_json& summary_case, const FigureContent& content,
                          const std::string& file_stem);

}  // namespace fpkcheck::compare
