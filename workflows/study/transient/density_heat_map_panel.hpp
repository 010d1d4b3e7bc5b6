#pragma once

#include <string>
#include <vector>

#include "report/figure/figure.hpp"

namespace fpkcheck::study {

/// A marginal density at several times.
struct DensityOverTime {
  std::vector<double> edges;  ///< increasing edges of cells
  std::vector<double> times = {};
  std::vector<const std::vector<double>*> averages = {};  ///< averages over cells at each time
};

/// Returns a heat map of a density over time.
/// @param symbol symbol of the variable, in gnuplot's enhanced text
/// @pre at least two times
report::FigurePanel density_heat_map_panel(const DensityOverTime& density, const std::string& title,
                                           const std::string& symbol);

}  // namespace fpkcheck::study
