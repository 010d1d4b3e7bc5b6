#pragma once

#include <vector>

#include "compare/axes.hpp"
#include "transform/density.hpp"

namespace fpkcheck::methods {

/// The points at which a density p(y, y') is wanted.
class DensityPoints {
 public:
  /// The cells are those of the axes, and go on with the same widths to 10/7 of them, so that what
  /// lies beyond the axes shows.
  explicit DensityPoints(const compare::ComparisonAxes& axes);

  const std::vector<double>& y_edges() const { return y_edges_; }
  const std::vector<double>& v_edges() const { return v_edges_; }
  /// y = 0, and then three Gauss-Legendre points a cell.
  const std::vector<double>& y() const { return y_; }
  /// Three Gauss-Legendre points a cell.
  const std::vector<double>& v() const { return v_; }

 private:
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
        sum +=
            weight_y_[i] * weight_v_[j] * value(i + 1, j) * g(points_.y()[i + 1], points_.v()[j]);
      }
    }
    return sum;
  }
  double mass() const {
    return of([](double, double) { return 1.0; });
  }
  /// Of the density divided by a mass.
  transform::Moments moments(double mass) const;
  /// int_{v<0} |v|^power p(0, v) dv.
  double impact_flux(int power) const;
  transform::GridDensity averages() const;

 private:
  double value(std::size_t i, std::size_t j) const { return values_[i * weight_v_.size() + j]; }

  const DensityPoints& points_;
  const std::vector<double>& values_;
  std::vector<double> weight_y_, weight_v_;
};

}  // namespace fpkcheck::methods
