#pragma once

#include <string>
#include <vector>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::paper {

/// A gnuplot script, and the name without extension under which it and its pictures are filed.
struct Figure {
  std::string stem, script;
};

/// The paper's Figs. 2-5, a case each: (a) p(y), (b) its logarithm, (c) p(y'), (d) its logarithm, of
/// EPC (n = 2), (n = 4), (n = 6) and MCS, under these names; a closure that is not `ok` has its status
/// beside the name. "paper-fig-2" and so on; none of a case that has none of these densities.
std::vector<Figure> figures(const results::Run& run,
                            report::FigureWidth width = report::FigureWidth::screen);

}  // namespace fpkcheck::paper
