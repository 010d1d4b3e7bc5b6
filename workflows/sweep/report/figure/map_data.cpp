#include "workflows/sweep/report/figure/map_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "report/figure/script_parts.hpp"
#include "workflows/sweep/report/figure/status_mark.hpp"

namespace fpkcheck::sweep {
namespace {

using transform::Status;

constexpr std::size_t kFewPoints = 300;

// Lower bound for distances, so that the logarithm is finite for a distance of 0.
double clamp_for_logarithm(double l1) { return std::max(l1, kMinColourDistance / 10); }

/// A point with a mark, which shows a status that is not ok, or that the method is the reference.
struct MarkedPoint {
  int type;
  std::size_t point;
};

std::vector<MarkedPoint> marked_points(const SweepView& view, std::size_t m) {
  std::vector<MarkedPoint> marked;
  for (const auto& point : view.results().points) {
    const Status status = point.methods[m].status;
    if (status != Status::ok) marked.push_back({point_type(status), point.point});
    if (view.is_reference(point.point, m)) marked.push_back({kReferenceMark, point.point});
  }
  return marked;
}

// The index of the tile that contains a value, for a given number of tiles along the axis.
std::size_t tile(const KeyAxis& axis, const base::Value& value, std::size_t tiles) {
  const auto count = static_cast<double>(tiles);
  return static_cast<std::size_t>(std::min(axis.relative_coordinate(value) * count, count - 1));
}

}  // namespace

MapData::MapData(const SweepView& view) : view_(view), x_(view.plan(), 0), y_(view.plan(), 1) {
  if (!has_cells()) return;
  cells_.assign(columns(), std::vector<std::size_t>(rows()));
  for (std::size_t point = 0; point < view.plan().points.size(); ++point) {
    const auto& values = view.plan().points[point];
    cells_[x_.cell_index(values[0])][y_.cell_index(values[1])] = point;
  }
}

std::array<double, 2> MapData::coordinates_of(std::size_t point) const {
  const auto& values = view_.plan().points[point];
  if (!has_cells()) return {x_.coordinate(values[0]), y_.coordinate(values[1])};
  return {static_cast<double>(x_.cell_index(values[0])),
          static_cast<double>(y_.cell_index(values[1]))};
}

std::string MapData::blocks(std::size_t m) const {
  std::string text;
  for (std::size_t j = 0; has_cells() && j < rows(); ++j) {
    for (std::size_t i = 0; i < columns(); ++i) {
      const auto l1 = view_.larger_l1(cells_[i][j], m);
      text += l1 ? fmt::format("{} {} {:.4g}\n", i, j, clamp_for_logarithm(*l1))
                 : fmt::format("{} {} NaN\n", i, j);
    }
    text += '\n';
  }
  for (std::size_t point = 0; !has_cells() && point < view_.plan().points.size(); ++point) {
    const auto l1 = view_.larger_l1(point, m);
    if (!l1) continue;
    const auto [x, y] = coordinates_of(point);
    text += fmt::format("{:.6g} {:.6g} {:.4g}\n", x, y, clamp_for_logarithm(*l1));
  }
  return report::data_block(fmt::format("map_{}", m), text.empty() ? "NaN NaN NaN\n" : text);
}

std::string MapData::mark_blocks(std::size_t m, std::size_t tiles_across, std::size_t tiles_up,
                                 std::set<int>& types) const {
  std::set<std::tuple<int, std::size_t, std::size_t>> taken;
  std::map<int, std::string> marks;
  const bool is_few = !has_cells() && view_.plan().points.size() <= kFewPoints;
  for (const auto& [type, point] : marked_points(view_, m)) {
    const auto [x, y] = coordinates_of(point);
    const auto& values = view_.plan().points[point];
    if (!is_few &&
        !taken.insert({type, tile(x_, values[0], tiles_across), tile(y_, values[1], tiles_up)})
             .second) {
      continue;
    }
    marks[type] += fmt::format("{:.6g} {:.6g}\n", x, y);
  }
  std::string text;
  for (const auto& [type, points] : marks) {
    types.insert(type);
    text += report::data_block(fmt::format("mark_{}_{}", m, type), points);
  }
  return text;
}

std::string MapData::outline_block(std::size_t m) const {
  if (!has_cells()) return "";
  const auto not_ok = [&](std::size_t i, std::size_t j) {
    const auto* one = view_.method_result(cells_[i][j], m);
    return one != nullptr && one->status != Status::ok;
  };
  std::string borders;
  for (std::size_t i = 0; i < columns(); ++i) {
    for (std::size_t j = 0; j < rows(); ++j) {
      const double x = static_cast<double>(i), y = static_cast<double>(j);
      if (i + 1 < columns() && not_ok(i, j) != not_ok(i + 1, j)) {
        borders += fmt::format("{0} {1}\n{0} {2}\n\n", x + 0.5, y - 0.5, y + 0.5);
      }
      if (j + 1 < rows() && not_ok(i, j) != not_ok(i, j + 1)) {
        borders += fmt::format("{0} {2}\n{1} {2}\n\n", x - 0.5, x + 0.5, y + 0.5);
      }
    }
  }
  return borders.empty() ? "" : report::data_block(fmt::format("outline_{}", m), borders);
}

bool MapData::has_contour(std::size_t m, double l1) const {
  if (!has_cells() || x_.has_words() || y_.has_words()) return false;
  const auto side = [&](std::size_t i, std::size_t j) {
    const auto found = view_.larger_l1(cells_[i][j], m);
    return !found ? 0 : *found < l1 ? -1 : 1;
  };
  // gnuplot computes contours within squares of four neighbouring cells.
  for (std::size_t i = 1; i < columns(); ++i) {
    for (std::size_t j = 1; j < rows(); ++j) {
      const int corner = side(i - 1, j - 1), right = side(i, j - 1), above = side(i - 1, j),
                far = side(i, j);
      const bool complete = corner * right * above * far != 0;
      if (complete && (corner != right || corner != above || corner != far)) return true;
    }
  }
  return false;
}

}  // namespace fpkcheck::sweep
