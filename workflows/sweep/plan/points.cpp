#include "workflows/sweep/plan/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/sobol.hpp>

#include "base/input_error.hpp"

namespace fpkcheck::sweep {
namespace {

void require_at_most_max_points(double count) {
  if (count <= static_cast<double>(kMaxPoints)) return;
  throw InputError(fmt::format("a plan of {:.3g} points (at most {}: vary less, or split the plan)",
                               count, kMaxPoints));
}

void require_values(const Axis& axis) {
  if (!axis.values.empty()) return;
  throw InputError(fmt::format("{} has no number of points (write {}:N, or --design sobol)",
                               axis.text(), axis.text()));
}

Points product(const std::vector<Axis>& axes) {
  double count = 1;
  for (const auto& axis : axes) {
    require_values(axis);
    count *= static_cast<double>(axis.values.size());
    require_at_most_max_points(count);
  }
  Points points{{}};
  for (const auto& axis : axes) {
    Points longer;
    for (const auto& point : points) {
      for (const auto& value : axis.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

Points list(const std::vector<Axis>& axes) {
  for (const auto& axis : axes) {
    require_values(axis);
    if (axis.values.size() == axes.front().values.size()) continue;
    throw InputError(
        fmt::format("{} has {} values and {} has {} (in a list all keys must have as many)",
                    axes.front().key, axes.front().values.size(), axis.key, axis.values.size()));
  }
  Points points(axes.front().values.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const auto& axis : axes) points[k].push_back(axis.values[k]);
  }
  return points;
}

// The Sobol sequence without its first point, which is a corner of the box (Sobol 1967; direction
// numbers of Joe and Kuo 2008).
Points sobol(const std::vector<Axis>& axes, std::size_t count) {
  if (count == 0) {
    throw InputError("the design sobol has no number of points (give --points N)");
  }
  require_at_most_max_points(static_cast<double>(count));
  for (const auto& axis : axes) {
    if (axis.spacing == Spacing::listed) {
      throw InputError(
          fmt::format("{} with the design sobol (it fills ranges: give FROM:TO)", axis.text()));
    }
    if (!axis.values.empty()) {
      throw InputError(fmt::format(
          "{} with the design sobol (--points sets the number: give FROM:TO)", axis.text()));
    }
  }
  boost::random::sobol engine(axes.size());
  const double above = static_cast<double>(boost::random::sobol::max()) + 1;
  Points points(count);
  for (auto& point : points) {
    for (const auto& axis : axes) {
      point.emplace_back(axis.value_at_fraction(static_cast<double>(engine()) / above));
    }
  }
  return points;
}

}  // namespace

Points make_points(const std::vector<Axis>& axes, PlanDesign design, std::size_t sobol_points) {
  if (axes.empty()) {
    throw InputError("nothing is varied (give --vary KEY=FROM:TO:N, log:FROM:TO:N or A,B,..)");
  }
  for (const auto& axis : axes) {
    if (std::ranges::count(axes, axis.key, &Axis::key) > 1) {
      throw InputError(fmt::format("{} is varied twice (keep one)", axis.key));
    }
  }
  if (design != PlanDesign::sobol && sobol_points != 0) {
    throw InputError("a number of points without the design sobol (the values of the axes set it)");
  }
  switch (design) {
    case PlanDesign::product:
      return product(axes);
    case PlanDesign::list:
      return list(axes);
    case PlanDesign::sobol:
      return sobol(axes, sobol_points);
  }
  return {};
}

}  // namespace fpkcheck::sweep
