#pragma once

#include <functional>
#include <span>
#include <variant>
#include <vector>

/// Joint densities of (y, y') between the walls: on the half-plane y >= 0 in the paper. Every
/// solver's result takes one of these two forms; all are normalised to 1, less atoms of rest.
namespace fpkcheck::transform {

/// Averages over rectilinear cells (finite differences, histograms).
struct GridDensity {
  std::vector<double> y_edges;   ///< ny + 1 increasing edges; walls are ends
  std::vector<double> v_edges;   ///< nv + 1 increasing edges
  std::vector<double> averages;  ///< row-major, shape (ny, nv)

  std::size_t ny() const { return y_edges.size() - 1; }
  std::size_t nv() const { return v_edges.size() - 1; }
  double average(std::size_t i, std::size_t j) const { return averages[i * nv() + j]; }
};

/// A function given pointwise, zero outside [y_min, y_max] x [-v_max, v_max].
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

/// A moment by its name in files and as people read it.
struct NamedMoment {
  const char* name;
  const char* symbol;
  double Moments::*moment;
  double Moments::*size;  ///< the moment that has its size: E[y'] is 0 but for errors
};
inline constexpr NamedMoment kMoments[] = {
    {"y1", "E[y]", &Moments::y1, &Moments::y1},    {"y2", "E[y^2]", &Moments::y2, &Moments::y2},
    {"y4", "E[y^4]", &Moments::y4, &Moments::y4},  {"v1", "E[y']", &Moments::v1, &Moments::v2},
    {"v2", "E[y'^2]", &Moments::v2, &Moments::v2}, {"v4", "E[y'^4]", &Moments::v4, &Moments::v4}};

/// Integral of g(y, v) p(y, v) over the support, by composite Gauss-Legendre panels on
/// [y_min, y_max] x [-v_max, 0] x [0, v_max].
double expectation(const SmoothDensity& density, const std::function<double(double, double)>& g);

/// int_{v<0} |v|^power p(0, v) dv: power 1 gives the impact rate, 3 twice the energy flux of paper
/// (2).
double impact_flux(const SmoothDensity& density, int power);

/// A joint density on axes: averages of the function over the cells between the edges, by three
/// Gauss-Legendre points a direction.
/// @param y_edges increasing, from 0; v_edges increasing, with 0 among them (p may jump there)
GridDensity on_cells(const SmoothDensity& density, std::span<const double> y_edges,
                     std::span<const double> v_edges);

/// The same of a density on other cells, exactly where the edges coincide and by MassTransfer along
/// both axes elsewhere: a histogram's edges should include the new ones, since its noise is no
/// polynomial.
GridDensity on_cells(const GridDensity& density, std::span<const double> y_edges,
                     std::span<const double> v_edges);

/// Sum of cell masses: 1 for a normalised density.
double mass(const GridDensity& density);

}  // namespace fpkcheck::transform
