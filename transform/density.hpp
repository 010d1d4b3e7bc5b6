#pragma once

#include <functional>
#include <span>
#include <variant>
#include <vector>

/// Joint densities of (y, y') between the walls: on the half-plane y >= 0 in the paper. Every
/// solver returns one of these two forms, of integral 1 minus the rest atoms.
namespace fpkcheck::transform {

/// Averages over rectilinear cells (finite volumes, histograms).
struct GridDensity {
  std::vector<double> y_edges;   ///< ny + 1 increasing edges; a wall is the first or last edge
  std::vector<double> v_edges;   ///< nv + 1 increasing edges
  std::vector<double> averages;  ///< row-major, shape (ny, nv)

  std::size_t ny() const { return y_edges.size() - 1; }
  std::size_t nv() const { return v_edges.size() - 1; }
  double average(std::size_t i, std::size_t j) const { return averages[i * nv() + j]; }
};

/// A density evaluated pointwise, zero outside [y_min, y_max] x [-v_max, v_max].
struct SmoothDensity {
  std::function<double(double y, double v)> value;
  double y_max;
  double v_max;
  double y_min = 0;
};

using Density = std::variant<GridDensity, SmoothDensity>;

/// Moments of y and y'.
struct Moments {
  double y1 = 0, y2 = 0, y4 = 0;  ///< E[y], E[y^2], E[y^4]
  double v1 = 0, v2 = 0, v4 = 0;  ///< E[y'], E[y'^2], E[y'^4]
};

/// A moment, with its key in files and its symbol in tables.
struct NamedMoment {
  const char* name;
  const char* symbol;
  double Moments::*moment;
  double Moments::*size;  ///< scale of relative errors: E[y'^2] for E[y'], which is exactly 0
};
inline constexpr NamedMoment kMoments[] = {
    {"y1", "E[y]", &Moments::y1, &Moments::y1},    {"y2", "E[y^2]", &Moments::y2, &Moments::y2},
    {"y4", "E[y^4]", &Moments::y4, &Moments::y4},  {"v1", "E[y']", &Moments::v1, &Moments::v2},
    {"v2", "E[y'^2]", &Moments::v2, &Moments::v2}, {"v4", "E[y'^4]", &Moments::v4, &Moments::v4}};

/// Integral of g(y, v) p(y, v) over the support, by a composite Gauss-Legendre rule on
/// [y_min, y_max] x [-v_max, 0] and [y_min, y_max] x [0, v_max].
double expectation(const SmoothDensity& density, const std::function<double(double, double)>& g);

/// int_{v<0} |v|^power p(0, v) dv. Power 1 gives the impact rate, power 3 twice the energy flux of
/// paper (2).
double impact_flux(const SmoothDensity& density, int power);

/// Averages of a pointwise density over cells, by three Gauss-Legendre points in each direction.
/// @param y_edges increasing, from 0; v_edges increasing, with 0 among them (p may jump there)
GridDensity average_over_cells(const SmoothDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges);

/// Averages of a density on cells over other cells: exact where the edges coincide, by
/// ConservativeRemap along both axes elsewhere. The edges of a histogram should include the new
/// edges, since polynomials do not interpolate its noise.
GridDensity average_over_cells(const GridDensity& density, std::span<const double> y_edges,
                               std::span<const double> v_edges);

/// Sum of the cell masses: 1 for a normalised density.
double mass(const GridDensity& density);

}  // namespace fpkcheck::transform
