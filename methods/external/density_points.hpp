#pragma once

#include <vector>

#include "compare/axes.hpp"
#include "problem/walls.hpp"
#include "transform/density.hpp"

namespace fpkcheck::methods {

/// The quadrature points at which an external density p(y, y') is evaluated.
class DensityPoints {
 public:
  /// The cells are those of the axes. Where there is no wall, further cells of the same width
  /// extend them to 10/7 of their length, to include mass beyond the axes.
  DensityPoints(const compare::ComparisonAxes& axes, const problem::Walls& walls);

  /// The walls that limit the points.
  const problem::Walls& walls() const { return walls_; }
  /// Whether the cells begin at the left wall, and end at the right wall.
  bool has_wall_at_start() const { return has_wall_at_start_; }
  bool has_wall_at_end() const { return has_wall_at_end_; }

  const std::vector<double>& y_edges() const { return y_edges_; }
  const std::vector<double>& v_edges() const { return v_edges_; }
  /// Three Gauss-Legendre points per cell. The left wall is the first point and the right wall the
  /// last, where the cells reach them.
  const std::vector<double>& y() const { return y_; }
  /// Three Gauss-Legendre points per cell.
  const std::vector<double>& v() const { return v_; }

 private:
  problem::Walls walls_;
  bool has_wall_at_start_, has_wall_at_end_;
  std::vector<double> y_edges_, v_edges_, y_, v_;
};

/// The edges of three subcells per cell, whose widths are the weights of the cell's points.
/// Averages over the subcells, taken as values at the points, then give the exact averages over the
/// cells.
std::vector<double> subcell_edges(const std::vector<double>& edges);

/// A density's values at the points, with the quadrature rule.
class PointIntegrals {
 public:
  /// @param points, values must outlive this object; values are row-major, shape (points.y(),
  ///        points.v())
  PointIntegrals(const DensityPoints& points, const std::vector<double>& values);

  /// int g(y, v) p(y, v) dy dv.
  template <class Function>
  double integrate(const Function& g) const {
    double sum = 0;
    for (std::size_t i = 0; i < weight_y_.size(); ++i) {
      for (std::size_t j = 0; j < weight_v_.size(); ++j) {
        const std::size_t row = first_ + i;
        sum += weight_y_[i] * weight_v_[j] * value(row, j) * g(points_.y()[row], points_.v()[j]);
      }
    }
    return sum;
  }
  double mass() const {
    return integrate([](double, double) { return 1.0; });
  }
  /// The moments of the density divided by `mass`.
  transform::Moments moments(double mass) const;
  /// int_{v<0} |v|^power p(a, v) dv at the left wall a; 0 where the points do not reach the wall.
  double left_flux(int power) const;
  /// int_{v>0} v^power p(b, v) dv at the right wall b, likewise.
  double right_flux(int power) const;
  /// The averages over the cells.
  transform::GridDensity averages() const;

 private:
  double value(std::size_t i, std::size_t j) const { return values_[i * weight_v_.size() + j]; }

  const DensityPoints& points_;
  const std::vector<double>& values_;
  std::size_t first_;  ///< row of the first cell's first point
  std::vector<double> weight_y_, weight_v_;
};

}  // namespace fpkcheck::methods
