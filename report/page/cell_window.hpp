#pragma once

#include <cstddef>
#include <vector>

#include "transform/density.hpp"

namespace fpkcheck::report {

/// The parts of its peak down to which a density is shown: on logarithmic scales (farther out a
/// simulation has few samples), and on linear ones.
inline constexpr double kSeen = 1e-5, kBulk = 1.0 / 500;

/// Half-open ranges of cells.
struct CellWindow {
  std::size_t y_end, v_begin, v_end, y_begin = 0;
};
/// Where the density exceeds this part of its peak, and from y = 0 on where the cells begin there; all
/// where it has none.
CellWindow window_above(const transform::GridDensity& density, double part);

/// The averages in a window as heat maps are drawn: shape (nv, ny).
std::vector<double> rows_of_constant_velocity(const transform::GridDensity& density,
                                              const CellWindow& window);

}  // namespace fpkcheck::report
