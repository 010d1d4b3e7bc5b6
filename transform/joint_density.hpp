#pragma once

#include <functional>
#include <span>
#include <variant>
#include <vector>

/// Joint densities of (y, y') between the walls, for the paper's oscillator on the half-plane y >=
/// 0. Every solver returns a GridDensity or a SmoothDensity. The integral of a joint density is 1
/// minus the probabilities of the atoms at rest.
namespace fpkcheck::transform {

/// A joint density given by averages over rectangular cells (from finite volumes or a histogram).
struct GridDensity {
  std::vector<double> y_edges;   ///< ny + 1 increasing cell edges; a wall is the first or last edge
  std::vector<double> v_edges;   ///< nv + 1 increasing cell edges
  std::vector<double> averages;  ///< averages over cells, row-major, shape (ny, nv)

  std::size_t y_cell_count() const { return y_edges.size() - 1; }
  std::size_t v_cell_count() const { return v_edges.size() - 1; }
  double cell_average(std::size_t i, std::size_t j) const {
    return averages[i * v_cell_count() + j];
  }
};

/// A joint density as a function of (y, v), zero outside [y_min, y_max] x [-v_max, v_max].
struct SmoothDensity {
  std::function<double(double y, double v)> value;
  double y_max;
  double v_max;
  double y_min = 0;
};

using Density = std::variant<GridDensity, SmoothDensity>;

struct Moments {
  double y1 = 0, y2 = 0, y4 = 0;  ///< moments E[y], E[y^2], E[y^4]
  double v1 = 0, v2 = 0, v4 = 0;  ///< moments E[y'], E[y'^2], E[y'^4]
};

struct NamedMoment {
  const char* name;
  const char* symbol;
  double Moments::*moment;
  /// Moment that scales the relative errors of a moment; the errors of E[y'] are scaled by E[y'^2],
  /// since E[y'] is exactly 0.
  double Moments::*size;
};
inline constexpr NamedMoment kMoments[] = {
    {"y1", "E[y]", &Moments::y1, &Moments::y1},    {"y2", "E[y^2]", &Moments::y2, &Moments::y2},
    {"y4", "E[y^4]", &Moments::y4, &Moments::y4},  {"v1", "E[y']", &Moments::v1, &Moments::v2},
    {"v2", "E[y'^2]", &Moments::v2, &Moments::v2}, {"v4", "E[y'^4]", &Moments::v4, &Moments::v4}};

/// Returns the expectation of a function g(y, v) under a joint density, computed with a composite
/// Gauss-Legendre rule on [y_min, y_max] x [-v_max, 0] and [y_min, y_max] x [0, v_max].
double expectation(const SmoothDensity& density, const std::function<double(double, double)>& g);

/// Returns the flux int_{v<0} |v|^power p(0, v) dv into the wall y = 0, which is the impact rate
/// for power 1 and twice the energy flux for power 3.
double flux_into_left_wall(const SmoothDensity& density, int power);

/// Averages a smooth density over cells, with three Gauss-Legendre points along each side of a
/// cell.
/// @param y_edges increasing cell edges in y; the first edge is 0
/// @param v_edges increasing cell edges in y' that include 0, where the density may be
/// discontinuous
GridDensity average_over_cells(const SmoothDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges);

/// Averages a density on cells over new cells, with ConservativeRemap along both axes. The new cell
/// averages are exact for cells whose edges coincide with old cell edges. The cell edges of a
/// histogram should include the new cell edges, since polynomial interpolation is inaccurate for
/// noisy data.
GridDensity average_over_cells(const GridDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges);

double mass(const GridDensity& density);

}  // namespace fpkcheck::transform
