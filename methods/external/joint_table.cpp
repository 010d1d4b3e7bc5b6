#include "methods/external/joint_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "methods/external/number_table.hpp"
#include "methods/external/range_between_walls.hpp"

// makima.hpp follows fpclassify, since makima of Boost 1.74 calls isnan without a declaration.
#include <boost/math/interpolators/makima.hpp>

namespace fpkcheck::methods {
namespace {

std::vector<double> distinct_values(const NumberTable& table, std::size_t column) {
  auto all = table.column_values(column);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::size_t value_index(const std::vector<double>& distinct_values, double value) {
  return static_cast<std::size_t>(std::ranges::lower_bound(distinct_values, value) -
                                  distinct_values.begin());
}

void require_axis(const std::vector<double>& axis, const char* symbol, const std::string& source) {
  constexpr std::size_t kMinPoints = 4;  // the interpolant needs four points
  if (axis.size() < kMinPoints) {
    throw InputError(fmt::format("{}: {} value{} of {} (must be at least {})", source, axis.size(),
                                 axis.size() == 1 ? "" : "s", symbol, kMinPoints));
  }
  for (std::size_t k = 0; k < axis.size(); ++k) {
    if (!(std::abs(axis[k]) < kMaxMagnitude)) {
      throw InputError(
          fmt::format("{}: {} = {:g} is too large; choose other units", source, symbol, axis[k]));
    }
    if (k > 0 && !(axis[k] > axis[k - 1])) {
      throw InputError(fmt::format("{}: {} = {:g} after {:g} (must increase)", source, symbol,
                                   axis[k], axis[k - 1]));
    }
  }
}

// Akima's modified interpolant of function values at increasing points; 0 outside their range.
class AkimaInterpolant {
 public:
  AkimaInterpolant(const std::vector<double>& at, std::vector<double> values)
      : first_(at.front()), last_(at.back()), cubic_(std::vector(at), std::move(values)) {}
  double operator()(double x) const { return x < first_ || x > last_ ? 0 : cubic_(x); }

 private:
  double first_, last_;
  boost::math::interpolators::makima<std::vector<double>> cubic_;
};

}  // namespace

bool is_joint_density(const NumberTable& table) {
  return table.column_count() == 3 && table.names.size() == 3 &&
         velocity_column_index(table.names) < 2;
}

JointTable make_joint_table(const NumberTable& table) {
  const std::size_t of_v = velocity_column_index(table.names), of_y = 1 - of_v;
  const std::string source = base::to_printable_text(table.source);
  JointTable joint{distinct_values(table, of_y), distinct_values(table, of_v), {}};
  require_axis(joint.y, "y", source);
  require_axis(joint.v, "y'", source);
  // The number of rows of the table is tested before memory is allocated, since a short file may
  // imply a huge grid.
  const std::size_t nv = joint.v.size(), rows = table.rows.size();
  if (joint.y.size() > rows / nv) {
    throw InputError(fmt::format(
        "{}: {} rows with {} values of y and {} of y' (must be one for every grid point)", source,
        rows, joint.y.size(), nv));
  }
  constexpr std::size_t kNone = 0;
  std::vector<std::size_t> row_of(joint.y.size() * nv,
                                  kNone);  // row number (from 1) of each grid point
  joint.p.resize(row_of.size());
  for (std::size_t k = 0; k < rows; ++k) {
    const auto& row = table.rows[k];
    const auto at = value_index(joint.y, row[of_y]) * nv + value_index(joint.v, row[of_v]);
    if (row_of[at] != kNone) {
      table.throw_row_error(k, fmt::format("y = {:g}, y' = {:g} occurs twice (first in line {})",
                                           row[of_y], row[of_v], table.lines[row_of[at] - 1]));
    }
    row_of[at] = k + 1;
    joint.p[at] = row[2];
  }
  // No grid point is missing in a table that has at least as many rows as grid points and in which
  // no grid point occurs twice.
  require_valid_joint_table(joint, source);
  return joint;
}

void require_valid_joint_table(const JointTable& table, const std::string& source) {
  require_axis(table.y, "y", source);
  require_axis(table.v, "y'", source);
  for (std::size_t k = 0; k < table.p.size(); ++k) {
    if (std::abs(table.p[k]) < kMaxMagnitude) continue;
    throw InputError(fmt::format("{}: p({:g}, {:g}) = {:g} (must be finite, and below {:g})",
                                 source, table.y[k / table.v.size()], table.v[k % table.v.size()],
                                 table.p[k], kMaxMagnitude));
  }
}

void require_range_between_walls(const problem::Walls& walls, double from, double to,
                                 const std::string& source) {
  for (const double y : {from, to}) {
    if (is_between_walls(walls, y)) continue;
    throw InputError(
        fmt::format("{}: y = {:g} (must be {})", source, y, admissible_range_text(walls)));
  }
}

std::vector<double> evaluate_at_quadrature_points(const JointTable& table,
                                                  const DensityQuadratureGrid& points) {
  const std::size_t ny = table.y.size(), nv = table.v.size();
  const double least = std::min(std::ranges::min(table.p), 0.0);
  // Values of the density at the displacements of the table and the velocities of the quadrature
  // points.
  std::vector<std::vector<double>> columns(points.v_points().size());
  for (std::size_t i = 0; i < ny; ++i) {
    const auto row = table.p.begin() + static_cast<std::ptrdiff_t>(i * nv);
    const AkimaInterpolant along_v(table.v, {row, row + static_cast<std::ptrdiff_t>(nv)});
    for (std::size_t j = 0; j < columns.size(); ++j)
      columns[j].push_back(along_v(points.v_points()[j]));
  }
  auto y = table.y;
  const auto to_walls = select_extrapolation_walls(points.walls(), y);
  if (to_walls.left) y.insert(y.begin(), points.walls().left->position);
  if (to_walls.right) y.push_back(points.walls().right->position);
  std::vector<double> values(points.y_points().size() * columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j) {
    auto& column = columns[j];
    const double at_left =
        to_walls.left ? extrapolate_to_wall(y.front(), table.y, column, 0, least) : 0;
    if (to_walls.right) {
      column.push_back(extrapolate_to_wall(y.back(), table.y, column, ny - 2, least));
    }
    if (to_walls.left) column.insert(column.begin(), at_left);
    const AkimaInterpolant along_y(y, std::move(column));
    for (std::size_t i = 0; i < points.y_points().size(); ++i) {
      values[i * columns.size() + j] = std::max(along_y(points.y_points()[i]), least);
    }
  }
  return values;
}

std::vector<double> evaluate_at_quadrature_points(const transform::GridDensity& cells,
                                                  const DensityQuadratureGrid& points) {
  const double least = std::min(std::ranges::min(cells.averages), 0.0);
  const auto parts = transform::average_over_cells(cells, subcell_edges(points.y_edges()),
                                                   subcell_edges(points.v_edges()));
  const std::size_t nv = parts.v_cell_count();
  std::vector<double> values;
  values.reserve((parts.y_cell_count() + 2) * nv);
  // Quadrature points at a wall belong to no subcell. The values at quadrature points at a wall are
  // extrapolated linearly from the next two subcells.
  const auto centre = [&](std::size_t i) { return (parts.y_edges[i] + parts.y_edges[i + 1]) / 2; };
  const auto add_wall = [&](double wall, std::size_t next, std::size_t after) {
    const double share = (centre(next) - wall) / (centre(after) - centre(next));
    for (std::size_t j = 0; j < nv; ++j) {
      const double first = parts.cell_average(next, j), second = parts.cell_average(after, j);
      values.push_back(std::max(first - share * (second - first), least));
    }
  };
  if (points.has_wall_at_start()) add_wall(parts.y_edges.front(), 0, 1);
  for (const double average : parts.averages) values.push_back(std::max(average, least));
  if (points.has_wall_at_end())
    add_wall(parts.y_edges.back(), parts.y_cell_count() - 1, parts.y_cell_count() - 2);
  return values;
}

}  // namespace fpkcheck::methods
