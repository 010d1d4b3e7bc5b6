#include "transform/marginal.hpp"

#include <algorithm>
#include <cmath>

#include "transform/panels.hpp"

namespace fpkcheck::transform {
namespace {

constexpr int kInterpolationPoints = 8;  // degree 7

/// Distribution function of one variable on the grid's own edges.
struct Cumulative {
  std::vector<double> edges;
  std::vector<double> values;

  double operator()(double x) const {
    if (x <= edges.front()) return 0;
    if (x >= edges.back()) return values.back();
    const auto above = std::lower_bound(edges.begin(), edges.end(), x);
    const auto k = above - edges.begin();
    if (*above == x) return values[k];
    const auto count = static_cast<std::ptrdiff_t>(edges.size());
    const auto points = std::min<std::ptrdiff_t>(kInterpolationPoints, count);
    const auto first = std::clamp<std::ptrdiff_t>(k - points / 2, 0, count - points);
    return lagrange(first, points, x);
  }

 private:
  double lagrange(std::ptrdiff_t first, std::ptrdiff_t points, double x) const {
    double sum = 0;
    for (auto a = first; a < first + points; ++a) {
      double weight = 1;
      for (auto b = first; b < first + points; ++b) {
        if (b != a) weight *= (x - edges[b]) / (edges[a] - edges[b]);
      }
      sum += weight * values[a];
    }
    return sum;
  }
};

Cumulative cumulative(const GridDensity& density, Variable variable) {
  const bool of_y = variable == Variable::y;
  const auto& edges = of_y ? density.y_edges : density.v_edges;
  std::vector<double> cell_mass(edges.size() - 1);
  for (std::size_t i = 0; i < density.ny(); ++i) {
    const double dy = density.y_edges[i + 1] - density.y_edges[i];
    for (std::size_t j = 0; j < density.nv(); ++j) {
      const double dv = density.v_edges[j + 1] - density.v_edges[j];
      cell_mass[of_y ? i : j] += density.average(i, j) * dy * dv;
    }
  }
  Cumulative result{edges, {0.0}};
  for (const double m : cell_mass) result.values.push_back(result.values.back() + m);
  return result;
}

std::vector<double> bin_averages(const GridDensity& density, Variable variable,
                                 std::span<const double> edges) {
  const Cumulative distribution = cumulative(density, variable);
  std::vector<double> averages;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    averages.push_back((distribution(edges[b + 1]) - distribution(edges[b])) /
                       (edges[b + 1] - edges[b]));
  }
  return averages;
}

std::vector<double> bin_averages(const SmoothDensity& density, Variable variable,
                                 std::span<const double> edges) {
  constexpr int kPanels = 6;
  const auto at = [&](double x) {
    if (variable == Variable::y) {
      const auto p = [&](double v) { return density.value(x, v); };
      return integrate_panels(p, -density.v_max, 0.0, kPanels) +
             integrate_panels(p, 0.0, density.v_max, kPanels);
    }
    return integrate_panels([&](double y) { return density.value(y, x); }, 0.0, density.y_max,
                            kPanels);
  };
  std::vector<double> averages;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    averages.push_back(average(at, edges[b], edges[b + 1]));
  }
  return averages;
}

}  // namespace

std::string_view name(Variable variable) { return variable == Variable::y ? "y" : "ydot"; }

Marginal marginal(const Density& density, Variable variable, std::span<const double> edges) {
  return {.edges = {edges.begin(), edges.end()},
          .density = std::visit(
              [&](const auto& form) { return bin_averages(form, variable, edges); }, density),
          .lower = {},
          .upper = {}};
}

}  // namespace fpkcheck::transform
