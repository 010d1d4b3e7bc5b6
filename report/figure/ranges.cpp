#include "report/figure/ranges.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::report {
namespace {

struct Extent {
  double from = 0, to = 0;
  bool empty = true;

  void include(double x) {
    from = empty ? x : std::min(from, x);
    to = empty ? x : std::max(to, x);
    empty = false;
  }
};

}  // namespace

FigureRanges figure_ranges(std::span<const DrawnCurve> curves) {
  constexpr double kVisiblePart = 1.0 / 500;
  Extent linear, logarithmic;
  double largest_density = 0, largest_difference = 0;
  for (const auto& drawn : curves) {
    const results::Curve* curve = drawn.curve;
    double peak = 0;
    for (const double p : curve->density) {
      if (std::isfinite(p)) peak = std::max(peak, p);
    }
    largest_density = std::max(largest_density, peak);
    for (std::size_t k = 0; k < curve->density.size(); ++k) {
      if (curve->density[k] > kVisiblePart * peak) linear.include(curve->abscissa[k]);
      if (curve->density[k] > kSmallestDrawnDensity) logarithmic.include(curve->abscissa[k]);
    }
    for (const double d : drawn.difference) {
      if (std::isfinite(d)) largest_difference = std::max(largest_difference, std::abs(d));
    }
    // Bin centres start half a bin beside the wall.
    if (curve->variable == transform::Variable::y) {
      linear.include(0);
      logarithmic.include(0);
    }
  }
  return {linear.from,    linear.to,       logarithmic.from,
          logarithmic.to, largest_density, largest_difference};
}

}  // namespace fpkcheck::report
