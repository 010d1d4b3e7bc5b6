#include "backward/residual/density_reconstruction.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/input_error.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::backward {
namespace {

constexpr unsigned kGaussPoints = 6;  // number of points of the Gauss rule of a panel
// Least number of quadrature panels over the range of a density that is given as a function
constexpr int kPanelsPerRange = 24;

/// Returns the composite Gauss rule on [begin, end], divided at the breaks of the integrands and of
/// the density.
numerics::QuadratureRule composite_rule(double begin, double end,
                                        std::span<const double> integrand_breaks,
                                        std::span<const double> density_breaks) {
  std::vector<double> cuts{begin, end};
  for (const auto& breaks : {integrand_breaks, density_breaks}) {
    std::ranges::copy_if(breaks, std::back_inserter(cuts),
                         [&](double x) { return begin < x && x < end; });
  }
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return numerics::composite_gauss_rule<kGaussPoints>(cuts);
}

/// Returns the quadrature rule of a density whose samples are cell averages.
DensityAxisQuadrature quadrature_of_cell_averages(const numerics::QuadratureRule& rule,
                                                  std::span<const double> edges) {
  RowMajorSparseMatrix rows = density_reconstruction_matrix(edges, rule.points);
  for (Eigen::Index n = 0; n < rows.rows(); ++n) rows.row(n) *= rule.weights(n);
  return {rule.points, std::move(rows)};
}

/// Returns the quadrature rule of a density whose samples are values at the quadrature points.
DensityAxisQuadrature quadrature_of_values(const numerics::QuadratureRule& rule) {
  RowMajorSparseMatrix rows(rule.weights.size(), rule.weights.size());
  rows.setIdentity();
  for (Eigen::Index n = 0; n < rows.rows(); ++n) rows.coeffRef(n, n) = rule.weights(n);
  return {rule.points, std::move(rows)};
}

void require_increasing_edges(std::span<const double> edges, const char* axis) {
  if (edges.size() < 2 ||
      std::ranges::adjacent_find(edges, std::greater_equal<>()) != edges.end()) {
    throw InputError(std::string("the cell edges of ") + axis + " do not increase");
  }
}

/// Range of a density in y. The comparisons of the ends of the density's range with a wall have a
/// tolerance for rounding errors.
struct DensityDisplacementRange {
  double low, high;

  bool has_end_at(const ImpactSpeedBreakpoints& wall) const {
    return std::abs((wall.rebound_sign > 0 ? low : high) - wall.wall_position) <=
           rounding_tolerance();
  }
  bool extends_past(const ImpactSpeedBreakpoints& wall) const {
    return wall.rebound_sign > 0 ? low < wall.wall_position - rounding_tolerance()
                                 : high > wall.wall_position + rounding_tolerance();
  }

 private:
  double rounding_tolerance() const { return 1e-12 * (high - low + std::abs(low)); }
};

SampledDensity sample_density_form(const transform::GridDensity& density,
                                   const IntegrandBreakpoints& breaks) {
  require_increasing_edges(density.y_edges, "y");
  require_increasing_edges(density.v_edges, "y'");
  const DensityDisplacementRange y_range{density.y_edges.front(), density.y_edges.back()};
  for (const ImpactSpeedBreakpoints& wall : breaks.impact_breaks) {
    if (wall.rebound_sign > 0 && !y_range.has_end_at(wall)) {
      throw InputError("the cells of y do not begin at the wall, y = 0");
    }
    if (y_range.extends_past(wall)) throw InputError("the cells of y extend past the wall");
  }
  if (density.averages.size() != density.y_cell_count() * density.v_cell_count()) {
    throw InputError("the number of averages differs from the number of cells");
  }
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> averages(density.averages.data(),
                                            static_cast<Eigen::Index>(density.y_cell_count()),
                                            static_cast<Eigen::Index>(density.v_cell_count()));
  const auto &y = density.y_edges, &v = density.v_edges;
  SampledDensity result{.y_quadrature = quadrature_of_cell_averages(
                            composite_rule(y.front(), y.back(), breaks.y_breaks, y), y),
                        .v_quadrature = quadrature_of_cell_averages(
                            composite_rule(v.front(), v.back(), breaks.v_breaks, v), v),
                        .samples = averages,
                        .wall_densities = {}};
  for (const ImpactSpeedBreakpoints& wall : breaks.impact_breaks) {
    // At a left wall the mirrored cells of the velocity v are the cells of the impact speed.
    std::vector<double> edges;
    for (const double edge : v) edges.push_back(-wall.rebound_sign * edge);
    if (wall.rebound_sign > 0) std::ranges::reverse(edges);
    const numerics::QuadratureRule rule =
        composite_rule(0, std::max(0.0, edges.back()), wall.breaks, edges);
    const double at[] = {wall.rebound_sign > 0 ? y.front() : y.back()};
    Eigen::VectorXd samples = (density_reconstruction_matrix(y, at) * averages).transpose();
    if (wall.rebound_sign > 0) samples.reverseInPlace();
    if (!y_range.has_end_at(wall)) samples.setZero();
    result.wall_densities.push_back({quadrature_of_cell_averages(rule, edges), std::move(samples)});
  }
  return result;
}

SampledDensity sample_density_form(const transform::SmoothDensity& density,
                                   const IntegrandBreakpoints& breaks) {
  const double range = density.y_max - density.y_min;
  if (!(range > 0) || !(density.v_max > 0) || !std::isfinite(range) ||
      !std::isfinite(density.v_max)) {
    throw InputError("a density given as a function has no finite positive range of y or y'");
  }
  const DensityDisplacementRange y_range{density.y_min, density.y_max};
  if (std::ranges::any_of(breaks.impact_breaks,
                          [&](const auto& wall) { return y_range.extends_past(wall); })) {
    throw InputError("the range of a density given as a function extends past the wall");
  }
  std::vector<double> y_panel_ends, v_panel_ends;
  for (int k = 1; k <= kPanelsPerRange; ++k) {
    y_panel_ends.push_back(density.y_min + range * k / kPanelsPerRange);
    for (const double sign : {-1.0, 1.0})
      v_panel_ends.push_back(sign * density.v_max * k / kPanelsPerRange);
  }
  SampledDensity result{.y_quadrature = quadrature_of_values(composite_rule(
                            density.y_min, density.y_max, breaks.y_breaks, y_panel_ends)),
                        .v_quadrature = quadrature_of_values(composite_rule(
                            -density.v_max, density.v_max, breaks.v_breaks, v_panel_ends)),
                        .samples = {},
                        .wall_densities = {}};
  const auto &y = result.y_quadrature.points, &v = result.v_quadrature.points;
  result.samples.resize(std::ssize(y), std::ssize(v));
  for (Eigen::Index j = 0; j < std::ssize(v); ++j) {
    for (Eigen::Index i = 0; i < std::ssize(y); ++i) {
      result.samples(i, j) =
          density.value(y[static_cast<std::size_t>(i)], v[static_cast<std::size_t>(j)]);
    }
  }
  for (const ImpactSpeedBreakpoints& wall : breaks.impact_breaks) {
    DensityAxisQuadrature speeds =
        quadrature_of_values(composite_rule(0, density.v_max, wall.breaks, v_panel_ends));
    Eigen::VectorXd samples = Eigen::VectorXd::Zero(std::ssize(speeds.points));
    // The position of the wall is clamped to the range in y of the density. If rounding put the
    // wall outside the range of the density, the density at the wall would be 0.
    const double at = std::clamp(wall.wall_position, density.y_min, density.y_max);
    for (Eigen::Index n = 0; y_range.has_end_at(wall) && n < samples.size(); ++n) {
      samples(n) =
          density.value(at, -wall.rebound_sign * speeds.points[static_cast<std::size_t>(n)]);
    }
    result.wall_densities.push_back({std::move(speeds), std::move(samples)});
  }
  return result;
}

}  // namespace

SampledDensity sample_density(const transform::Density& density,
                              const IntegrandBreakpoints& breaks) {
  return std::visit([&](const auto& form) { return sample_density_form(form, breaks); }, density);
}

namespace {

constexpr std::ptrdiff_t kStencilEdges = 8;  // number of nodes of a polynomial of degree 7

/// Returns the slopes at x of the Lagrange polynomials with the given cell edges as nodes.
std::vector<double> lagrange_slopes(std::span<const double> edges, double x) {
  std::vector<double> slopes;
  for (std::size_t a = 0; a < edges.size(); ++a) {
    double slope = 0;
    for (std::size_t left_out = 0; left_out < edges.size(); ++left_out) {
      if (left_out == a) continue;
      double product = 1 / (edges[a] - edges[left_out]);
      for (std::size_t b = 0; b < edges.size(); ++b) {
        if (b != a && b != left_out) product *= (x - edges[b]) / (edges[a] - edges[b]);
      }
      slope += product;
    }
    slopes.push_back(slope);
  }
  return slopes;
}

}  // namespace

RowMajorSparseMatrix density_reconstruction_matrix(std::span<const double> edges,
                                                   std::span<const double> points) {
  const auto zero = std::ranges::lower_bound(edges, 0.0) - edges.begin();
  const bool has_edge_at_zero =
      zero < std::ssize(edges) && edges[static_cast<std::size_t>(zero)] == 0;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const double x = points[n];
    if (x < edges.front() || x > edges.back()) continue;
    // The cell edges with the indices k - 1 and k enclose the cell that contains the point x. The
    // cell edges with the indices begin .. end - 1 lie on the same side of 0 as the point x.
    const auto k = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(edges, x) - edges.begin(), 1,
                                              std::ssize(edges) - 1);
    const std::ptrdiff_t begin = has_edge_at_zero && k > zero ? zero : 0;
    const std::ptrdiff_t end = has_edge_at_zero && k <= zero ? zero + 1 : std::ssize(edges);
    const auto count = std::min(kStencilEdges, end - begin);
    const auto first = std::clamp(k - count / 2, begin, end - count);
    const auto chosen =
        edges.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    const std::vector<double> slopes = lagrange_slopes(chosen, x);
    // The cumulative distribution at a cell edge is the sum of the probabilities of all cells below
    // the edge. The sum of the slopes of all Lagrange polynomials at a point is 0.
    double sum = 0;
    for (auto a = count - 1; a > 0; --a) {
      const auto at = static_cast<std::size_t>(a);
      sum += slopes[at];
      entries.emplace_back(static_cast<int>(n), static_cast<int>(first + a - 1),
                           sum * (chosen[at] - chosen[at - 1]));
    }
  }
  RowMajorSparseMatrix rows(static_cast<Eigen::Index>(points.size()), std::ssize(edges) - 1);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

}  // namespace fpkcheck::backward
