#include "fd_fpk/axis/faces_by_width.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::fd_fpk {

std::vector<double> faces_with_local_width(std::span<const double> anchors,
                                           const std::function<double(double)>& width) {
  constexpr double kStepFraction =
      0.05;  // fraction of a cell over which the width is nearly constant
  std::vector<double> faces{anchors.front()};
  std::vector<double> x, cells;  // cells[k]: number of cells up to x[k]
  for (std::size_t n = 0; n + 1 < anchors.size(); ++n) {
    const double from = anchors[n], to = anchors[n + 1];
    x.assign(1, from);
    cells.assign(1, 0);
    while (x.back() < to) {
      // Next to an anchor with narrow cells the cell width decreases over the step. The step then
      // uses the smaller width.
      double step = kStepFraction * width(x.back());
      step = std::min(step, kStepFraction * width(std::min(to, x.back() + step)));
      const double next = x.back() + step < to ? x.back() + step : to;
      cells.push_back(cells.back() + (next - x.back()) / width((x.back() + next) / 2));
      x.push_back(next);
    }
    const int count = std::max(1, static_cast<int>(std::ceil(cells.back() - 1e-9)));
    std::size_t k = 0;
    for (int f = 1; f < count; ++f) {
      const double wanted = cells.back() * f / count;
      while (cells[k + 1] < wanted) ++k;
      const double part = (wanted - cells[k]) / (cells[k + 1] - cells[k]);
      faces.push_back(x[k] + part * (x[k + 1] - x[k]));
    }
    faces.push_back(to);
  }
  return faces;
}

}  // namespace fpkcheck::fd_fpk
