#include "dual/residual/sampled_density.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

#include "dual/spline/gauss_rule.hpp"
#include "parameters/input_error.hpp"

namespace fpkcheck::dual {
namespace {

constexpr unsigned kSixPoints = 6;
constexpr int kPanelsOfRange = 24;

/// On [begin, end], cut at both kinds of breaks.
QuadratureRule rule_between(double begin, double end, std::span<const double> a,
                            std::span<const double> b) {
  std::vector<double> cuts{begin, end};
  for (const auto& breaks : {a, b}) {
    std::ranges::copy_if(breaks, std::back_inserter(cuts),
                         [&](double x) { return begin < x && x < end; });
  }
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return gauss_rule<kSixPoints>(cuts);
}

/// The samples are averages over cells.
SampledAxis of_averages(const QuadratureRule& rule, std::span<const double> edges) {
  SparseRows rows = reconstruction(edges, rule.points);
  for (Eigen::Index n = 0; n < rows.rows(); ++n) rows.row(n) *= rule.weights(n);
  return {rule.points, std::move(rows)};
}

/// The samples are values at the points.
SampledAxis of_values(const QuadratureRule& rule) {
  SparseRows rows(rule.weights.size(), rule.weights.size());
  rows.setIdentity();
  for (Eigen::Index n = 0; n < rows.rows(); ++n) rows.coeffRef(n, n) = rule.weights(n);
  return {rule.points, std::move(rows)};
}

void check_edges(std::span<const double> edges, const char* axis) {
  if (edges.size() < 2 ||
      std::ranges::adjacent_find(edges, std::greater_equal<>()) != edges.end()) {
    throw InputError(std::string("the edges of the cells of ") + axis + " must increase");
  }
}

SampledDensity sampled_form(const transform::GridDensity& density, const IntegrandBreaks& breaks) {
  check_edges(density.y_edges, "y");
  check_edges(density.v_edges, "y'");
  if (density.y_edges.front() != 0) throw InputError("the cells of y must begin at 0, the wall");
  if (density.averages.size() != density.ny() * density.nv()) {
    throw InputError("a density on cells needs one average for each of them");
  }
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> averages(density.averages.data(),
                                            static_cast<Eigen::Index>(density.ny()),
                                            static_cast<Eigen::Index>(density.nv()));
  const auto &y = density.y_edges, &v = density.v_edges;
  // Along the wall by the speed of impact: the same cells, mirrored.
  std::vector<double> speed_edges;
  for (const double edge : v) speed_edges.push_back(-edge);
  std::ranges::reverse(speed_edges);
  const double wall[] = {0.0};
  const QuadratureRule impacts =
      rule_between(0, std::max(0.0, -v.front()), breaks.wall, speed_edges);
  SampledDensity result{
      .y = of_averages(rule_between(0, y.back(), breaks.y, y), y),
      .v = of_averages(rule_between(v.front(), v.back(), breaks.v, v), v),
      .samples = averages,
      .wall = of_averages(impacts, speed_edges),
      .wall_samples = (reconstruction(y, wall) * averages).transpose().colwise().reverse()};
  return result;
}

SampledDensity sampled_form(const transform::SmoothDensity& density,
                            const IntegrandBreaks& breaks) {
  if (!(density.y_max > 0) || !(density.v_max > 0) || !std::isfinite(density.y_max) ||
      !std::isfinite(density.v_max)) {
    throw InputError("a density given as a function needs a finite range of y and of y'");
  }
  std::vector<double> in_y, in_v;
  for (int k = 1; k <= kPanelsOfRange; ++k) {
    in_y.push_back(density.y_max * k / kPanelsOfRange);
    for (const double sign : {-1.0, 1.0}) in_v.push_back(sign * density.v_max * k / kPanelsOfRange);
  }
  SampledDensity result{.y = of_values(rule_between(0, density.y_max, breaks.y, in_y)),
                        .v = of_values(rule_between(-density.v_max, density.v_max, breaks.v, in_v)),
                        .samples = {},
                        .wall = of_values(rule_between(0, density.v_max, breaks.wall, in_v)),
                        .wall_samples = {}};
  const auto &y = result.y.points, &v = result.v.points, &wall = result.wall.points;
  result.samples.resize(std::ssize(y), std::ssize(v));
  for (Eigen::Index j = 0; j < std::ssize(v); ++j) {
    for (Eigen::Index i = 0; i < std::ssize(y); ++i) {
      result.samples(i, j) =
          density.value(y[static_cast<std::size_t>(i)], v[static_cast<std::size_t>(j)]);
    }
  }
  result.wall_samples.resize(std::ssize(wall));
  for (Eigen::Index n = 0; n < std::ssize(wall); ++n) {
    result.wall_samples(n) = density.value(0, -wall[static_cast<std::size_t>(n)]);
  }
  return result;
}

}  // namespace

SampledDensity sampled(const transform::Density& density, const IntegrandBreaks& breaks) {
  return std::visit([&](const auto& form) { return sampled_form(form, breaks); }, density);
}

}  // namespace fpkcheck::dual
