#pragma once

#include <vector>

#include "compare/axes.hpp"
#include "problem/walls.hpp"
#include "transform/density.hpp"

namespace fpkcheck::methods {

/// The points at which a density p(y, y') is wanted.
class DensityPoints {
 public:
  /// The cells are those of the axes, and go on with the same widths to 10/7 of them where no wall
  /// stands, so that what lies beyond the axes shows.
  DensityPoints(const compare::ComparisonAxes& axes, const problem::Walls& walls);

  /// Between which they lie.
  const problem::Walls& walls() const { return walls_; }
  /// Whether the cells begin at a wall on the left, and end at one on the right.
  bool begin_at_wall() const { return begin_at_wall_; }
  bool end_at_wall() const { return end_at_wall_; }

  const std::vector<double>& y_edges() const { return y_edges_; }
  const std::vector<double>& v_edges() const { return v_edges_; }
  /// Three Gauss-Legendre points a cell; before them the wall on the left, after them that on the
  /// right, where the cells reach it.
  const std::vector<double>& y() const { return y_; }
  /// Three Gauss-Legendre points a cell.
  const std::vector<double>& v() const { return v_; }

 private:
  problem::Walls walls_;
  bool begin_at_wall_, end_at_wall_;
  std::vector<double> y_edges_, v_edges_, y_, v_;
};

/// Each cell cut into three by the weights of its points, so that averages over these parts, taken
/// as values at the points, have the very averages over the cells.
std::vector<double> edges_of_parts(const std::vector<double>& edges);

/// A density's values at the points, with the rule that integrates them.
class PointIntegrals {
 public:
  /// @param points, values row-major of shape (points.y(), points.v()): both outlive it
  PointIntegrals(const DensityPoints& points, const std::vector<double>& values);

  /// int g(y, v) p(y, v) dy dv.
  template <class Function>
  double of(const Function& g) const {
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
    return of([](double, double) { return 1.0; });
  }
  /// Of the density divided by a mass.
  transform::Moments moments(double mass) const;
  /// int_{v<0} |v|^power p(a, v) dv at the wall on the left, 0 where the points do not reach it.
  double left_flux(int power) const;
  /// int_{v>0} v^power p(b, v) dv at the one on the right, likewise.
  double right_flux(int power) const;
  transform::GridDensity averages() const;

 private:
  double value(std::size_t i, std::size_t j) const { return values_[i * weight_v_.size() + j]; }

  const DensityPoints& points_;
  const std::vector<double>& values_;
  std::size_t first_;  ///< row of the first cell
  std::vector<double> weight_y_, weight_v_;
};

}  // namespace fpkcheck::methods
