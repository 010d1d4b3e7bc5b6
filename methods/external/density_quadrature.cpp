#include "methods/external/density_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "methods/external/range_between_walls.hpp"

namespace fpkcheck::methods {
namespace {

// Extends a list of bin edges by the length `extension`, with bins of the width of the last bin.
std::vector<double> extend_edges(std::vector<double> edges, double extension) {
  const double last = edges.back(), width = last - edges[edges.size() - 2];
  const auto more = static_cast<int>(std::lround(extension / width));
  for (int k = 1; k <= more; ++k) edges.push_back(last + k * width);
  return edges;
}

std::vector<double> reflect_edges(std::vector<double> edges) {
  for (double& edge : edges) edge = -edge;
  std::ranges::reverse(edges);
  return edges;
}

// Extends the cell edges in y at the low and the high end as requested, but not beyond a wall.
std::vector<double> extend_edges(const std::vector<double>& edges, bool low, bool high,
                                 const problem::Walls& walls) {
  const double length = edges.back() - edges.front();
  const double extension = length * 3 / 7 / (low && high ? 2 : 1);
  std::vector<double> all = edges;
  if (high) all = extend_edges(all, extension);
  if (low) all = reflect_edges(extend_edges(reflect_edges(all), extension));
  std::erase_if(all, [&](double edge) {
    return (edge < edges.front() || edge > edges.back()) && !is_between_walls(walls, edge);
  });
  return all;
}

std::vector<double> mirror_edges(const std::vector<double>& edges) {
  std::vector<double> both;
  for (auto edge = edges.rbegin(); edge != edges.rend() && *edge > 0; ++edge) {
    both.push_back(-*edge);
  }
  both.insert(both.end(), edges.begin(), edges.end());
  return both;
}

constexpr std::size_t kPointsPerCell = 3;
constexpr std::array<double, kPointsPerCell> kGaussWeights{5.0 / 18, 8.0 / 18, 5.0 / 18};

void add_gauss_points(const std::vector<double>& edges, std::vector<double>& points) {
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double centre = (edges[k] + edges[k + 1]) / 2, half = (edges[k + 1] - edges[k]) / 2;
    for (const double at : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) {
      points.push_back(centre + at * half);
    }
  }
}

std::vector<double> quadrature_weights(const std::vector<double>& edges) {
  std::vector<double> all;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    for (const double weight : kGaussWeights) all.push_back(weight * (edges[k + 1] - edges[k]));
  }
  return all;
}

}  // namespace

DensityQuadratureGrid::DensityQuadratureGrid(const compare::ComparisonBins& axes,
                                             const problem::Walls& walls)
    : walls_(walls),
      has_wall_at_start_(is_at_wall(walls.left, axes.y_edges.front())),
      has_wall_at_end_(is_at_wall(walls.right, axes.y_edges.back())),
      y_edges_(extend_edges(axes.y_edges, !has_wall_at_start_, !has_wall_at_end_, walls)) {
  const auto rest = std::ranges::find(axes.v_edges, 0.0);
  v_edges_ = mirror_edges(extend_edges({rest, axes.v_edges.end()}, axes.v_edges.back() * 3 / 7));
  if (has_wall_at_start_) y_.push_back(y_edges_.front());
  add_gauss_points(y_edges_, y_);
  if (has_wall_at_end_) y_.push_back(y_edges_.back());
  add_gauss_points(v_edges_, v_);
}

std::vector<double> subcell_edges(const std::vector<double>& edges) {
  std::vector<double> parts{edges.front()};
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double width = edges[k + 1] - edges[k];
    parts.push_back(edges[k] + kGaussWeights[0] * width);
    parts.push_back(edges[k + 1] - kGaussWeights[2] * width);
    parts.push_back(edges[k + 1]);
  }
  return parts;
}

DensityIntegrals::DensityIntegrals(const DensityQuadratureGrid& points,
                                   const std::vector<double>& values)
    : points_(points),
      values_(values),
      first_(points.has_wall_at_start() ? 1 : 0),
      weight_y_(quadrature_weights(points.y_edges())),
      weight_v_(quadrature_weights(points.v_edges())) {}

transform::Moments DensityIntegrals::moments(double mass) const {
  const auto mean = [&](const auto& g) { return integrate_times_density(g) / mass; };
  return {.y1 = mean([](double y, double) { return y; }),
          .y2 = mean([](double y, double) { return y * y; }),
          .y4 = mean([](double y, double) { return y * y * y * y; }),
          .v1 = mean([](double, double v) { return v; }),
          .v2 = mean([](double, double v) { return v * v; }),
          .v4 = mean([](double, double v) { return v * v * v * v; })};
}

double DensityIntegrals::flux_integral(std::size_t row, double direction,
                                       const std::function<double(double)>& weight) const {
  double sum = 0;
  for (std::size_t j = 0; j < weight_v_.size(); ++j) {
    const double speed = direction * points_.v_points()[j];
    if (speed > 0) sum += weight_v_[j] * speed * weight(speed) * value(row, j);
  }
  return sum;
}

double DensityIntegrals::sum_over_left_impacts(const std::function<double(double)>& weight) const {
  return points_.has_wall_at_start() ? flux_integral(0, -1, weight) : 0;
}

double DensityIntegrals::sum_over_right_impacts(const std::function<double(double)>& weight) const {
  return points_.has_wall_at_end() ? flux_integral(points_.y_points().size() - 1, 1, weight) : 0;
}

transform::GridDensity DensityIntegrals::cell_averages() const {
  transform::GridDensity grid{points_.y_edges(), points_.v_edges(), {}};
  for (std::size_t i = 0; i < grid.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < grid.v_cell_count(); ++j) {
      double sum = 0;
      for (std::size_t a = 0; a < kPointsPerCell; ++a) {
        for (std::size_t b = 0; b < kPointsPerCell; ++b) {
          sum += kGaussWeights[a] * kGaussWeights[b] *
                 value(first_ + kPointsPerCell * i + a, kPointsPerCell * j + b);
        }
      }
      grid.averages.push_back(sum);
    }
  }
  return grid;
}

}  // namespace fpkcheck::methods
