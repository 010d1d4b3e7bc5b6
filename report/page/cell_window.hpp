#pragma once

#include <cstddef>
#include <vector>

#include "transform/density.hpp"

namespace fpkcheck::report {

/// Fractions of the peak down to which a joint density is shown, on logarithmic and on linear
/// colour scales. Below the fraction for logarithmic scales a simulation has few samples.
inline constexpr double kLogarithmicFraction = 1e-5, kLinearFraction = 1.0 / 500;

/// Half-open ranges of cells in y and y'.
struct CellWindow {
  std::size_t y_end, v_begin, v_end, y_begin = 0;
};
/// The window of the cells with a density above a fraction of the peak. The window includes y = 0
/// if the cells begin at y = 0. Without a positive peak the window has all cells.
CellWindow cells_above_fraction(const transform::GridDensity& density, double part);

/// The cell averages in a window as rows of constant y', shape (nv, ny), the order that heat maps
/// require.
std::vector<double> rows_of_constant_velocity(const transform::GridDensity& density,
                                              const CellWindow& window);

}  // namespace fpkcheck::report
