#pragma once

#include <cstddef>
#include <vector>

#include "transform/density.hpp"

namespace fpkcheck::report {

/// Fractions of its peak down to which a density is shown: on logarithmic scales (below, a
/// simulation has few samples) and on linear scales.
inline constexpr double kLogarithmicFraction = 1e-5, kLinearFraction = 1.0 / 500;

/// Half-open ranges of cells in y and y'.
struct CellWindow {
  std::size_t y_end, v_begin, v_end, y_begin = 0;
};
/// The cells with a density above this fraction of the peak, including y = 0 if the cells begin
/// there; all cells without a positive peak.
CellWindow window_above(const transform::GridDensity& density, double part);

/// The averages in a window as rows of constant y', shape (nv, ny), the order of heat maps.
std::vector<double> rows_of_constant_velocity(const transform::GridDensity& density,
                                              const CellWindow& window);

}  // namespace fpkcheck::report
