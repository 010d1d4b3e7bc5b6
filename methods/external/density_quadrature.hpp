#pragma once

#include <functional>
#include <vector>

#include "compare/comparison_bins.hpp"
#include "problem/walls.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::methods {

/// The cells and quadrature points at which an external joint density p(y, y') is evaluated.
class DensityQuadratureGrid {
 public:
  /// Makes the quadrature cells from the comparison axes. On each side without a wall, additional
  /// cells extend the range of the comparison axes to 10/7 of its length, to include the mass
  /// outside the comparison axes.
  DensityQuadratureGrid(const compare::ComparisonBins& axes, const problem::Walls& walls);

  const problem::Walls& walls() const { return walls_; }
  /// Returns whether the quadrature cells in y begin at the left wall.
  bool has_wall_at_start() const { return has_wall_at_start_; }
  /// Returns whether the quadrature cells in y end at the right wall.
  bool has_wall_at_end() const { return has_wall_at_end_; }

  const std::vector<double>& y_edges() const { return y_edges_; }
  const std::vector<double>& v_edges() const { return v_edges_; }
  /// Returns the quadrature points in y: three Gauss-Legendre points per cell. A wall at the first
  /// or at the last cell edge is an additional quadrature point.
  const std::vector<double>& y_points() const { return y_; }
  /// Returns the quadrature points in y': three Gauss-Legendre points per cell.
  const std::vector<double>& v_points() const { return v_; }

 private:
  problem::Walls walls_;
  bool has_wall_at_start_, has_wall_at_end_;
  std::vector<double> y_edges_, v_edges_, y_, v_;
};

/// Returns the edges of three subcells of each cell. The widths of the three subcells are the
/// Gauss-Legendre weights of the cell. For values at the quadrature points that are averages of a
/// density over the subcells, the quadrature gives the exact cell averages of the density.
std::vector<double> subcell_edges(const std::vector<double>& edges);

/// Integrals of an external density p(y, y'), from the values of p at the quadrature points.
class DensityIntegrals {
 public:
  /// The arguments `points` and `values` must outlive the DensityIntegrals object.
  /// @param values values of the density p at the quadrature points, row-major, shape
  /// (points.y_points(), points.v_points())
  DensityIntegrals(const DensityQuadratureGrid& points, const std::vector<double>& values);

  /// Returns the integral of a function times the density, int g(y, v) p(y, v) dy dv.
  template <class Function>
  double integrate_times_density(const Function& g) const {
    double sum = 0;
    for (std::size_t i = 0; i < weight_y_.size(); ++i) {
      for (std::size_t j = 0; j < weight_v_.size(); ++j) {
        const std::size_t row = first_ + i;
        sum += weight_y_[i] * weight_v_[j] * value(row, j) *
               g(points_.y_points()[row], points_.v_points()[j]);
      }
    }
    return sum;
  }
  double mass() const {
    return integrate_times_density([](double, double) { return 1.0; });
  }
  /// Returns the moments of the density divided by `mass`.
  transform::Moments moments(double mass) const;
  /// Returns int_{v<0} |v| weight(|v|) p(a, v) dv over impact velocities at the left wall y = a,
  /// the sum of weight(u) over impacts at speed u per unit time; 0 if the quadrature cells do not
  /// begin at the left wall.
  double sum_over_left_impacts(const std::function<double(double)>& weight) const;
  /// Returns int_{v>0} v weight(v) p(b, v) dv over impact velocities at the right wall y = b, the
  /// sum of weight(u) over impacts at speed u per unit time; 0 if the quadrature cells do not end
  /// at the right wall.
  double sum_over_right_impacts(const std::function<double(double)>& weight) const;
  transform::GridDensity cell_averages() const;

 private:
  /// Returns the integral of |v| weight(|v|) p(y, v) over velocities v with the sign of
  /// `direction`, at the displacement y of one row of quadrature points.
  double flux_integral(std::size_t row, double direction,
                       const std::function<double(double)>& weight) const;
  double value(std::size_t i, std::size_t j) const { return values_[i * weight_v_.size() + j]; }

  const DensityQuadratureGrid& points_;
  const std::vector<double>& values_;
  std::size_t first_;  ///< index in y of the first quadrature point of the first cell
  std::vector<double> weight_y_, weight_v_;
};

}  // namespace fpkcheck::methods
