#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "transform/joint_density.hpp"

namespace fpkcheck::report {

/// Smallest fractions of the peak at which a joint density is shown, on logarithmic and on linear
/// colour scales. A simulation has few samples in cells with a density below the fraction
/// kLogarithmicFraction of the peak.
inline constexpr double kLogarithmicFraction = 1e-5, kLinearFraction = 1.0 / 500;

struct CellIndexWindow {
  std::size_t y_end, v_begin, v_end, y_begin = 0;
};
/// Returns the index window of the cells with a density above `part` times the peak density. The
/// window of cells includes y = 0 if the cells of the grid begin at y = 0. If the density is
/// nowhere positive, the window contains all cells of the grid.
CellIndexWindow window_of_cells_above_peak_fraction(const transform::GridDensity& density,
                                                    double part);

/// Returns the cell averages in a window as rows of constant y' with the shape (nv, ny), as heat
/// maps store values.
std::vector<double> cell_averages_by_velocity_rows(const transform::GridDensity& density,
                                                   const CellIndexWindow& window);

/// Signed numbers, quantised to integers q from -levels to levels. The integer q, at most `levels`
/// in magnitude, represents the number sign(q) (q / levels)^2 times the largest magnitude. The
/// signed square-root scale resolves small values in the tails of a density.
struct QuantisedSignedRoots {
  double largest;  ///< largest magnitude of the numbers
  int levels;
  std::vector<int> roots;  ///< quantised numbers, from -levels to levels
};

/// Quantises signed numbers to integers by the signed square root.
/// @param levels number of steps on each side of 0; magnitudes below the largest magnitude / (4
///        levels^2) become 0
QuantisedSignedRoots quantise_signed_roots(std::span<const double> values, int levels);

/// Returns the first number, followed by the differences of successive numbers. Successive
/// differences of smooth data are small integers, which compress well.
std::vector<int> successive_differences(std::span<const int> values);

}  // namespace fpkcheck::report
