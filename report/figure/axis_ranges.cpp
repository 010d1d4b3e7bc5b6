#include "report/figure/density_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::report {
namespace {

struct DensityAxisExtent {
  double from = 0, to = 0;
  bool empty = true;

  void include(double x) {
    from = empty ? x : std::min(from, x);
    to = empty ? x : std::max(to, x);
    empty = false;
  }
};

constexpr double kVisibleFraction = 1.0 / 500;

// Extends the axis ranges by half a bin to the wall y = 0, and to each end of the binned range at
// which the density has not decayed.
void include_ends_of_bins(const results::DensityCurve& curve, double peak,
                          DensityAxisExtent& linear, DensityAxisExtent& logarithmic) {
  const auto widths = results::bin_widths(curve);
  if (widths.empty()) return;
  const double low = curve.abscissa.front() - widths.front() / 2;
  const double high = curve.abscissa.back() + widths.back() / 2;
  const bool at_zero = std::abs(low) < widths.front() / 100;
  constexpr double kNotDecayed = 1.0 / 20;
  const auto is_visible = [&](double density) { return density > kNotDecayed * peak; };
  for (DensityAxisExtent* extent : {&linear, &logarithmic}) {
    if (at_zero) {
      extent->include(0);
    } else if (is_visible(curve.density.front())) {
      extent->include(low);
    }
    if (is_visible(curve.density.back())) extent->include(high);
  }
}

}  // namespace

std::vector<bool> DrawnDensityCurve::undivided_bin_flags() const {
  const auto widths = results::bin_widths(*curve);
  const double widest = widths.empty() ? 0 : std::ranges::max(widths);
  std::vector<bool> has_full_width;
  for (const double width : widths) has_full_width.push_back(width > widest / 2);
  return has_full_width;
}

std::pair<double, double> difference_axis_decades(const MarginalAxisRanges& r) {
  if (!(r.largest_difference > 0)) return {1e-6, 1};
  const double to = std::pow(10, std::ceil(std::log10(r.largest_difference)));
  const double from = std::pow(10, std::floor(std::log10(r.least_difference)) - 2);
  return {std::max(from, 1e-8 * to), to};
}

double logarithmic_axis_bottom(const MarginalAxisRanges& ranges, double floor) {
  // The factor 0.8 leaves space between the lowest point of the density and the bottom axis.
  const double least = std::min(0.8 * ranges.least_density, logarithmic_axis_top(ranges) / 10);
  return least > floor ? std::pow(10, std::floor(std::log10(least))) : floor;
}

std::string density_spike_note(const MarginalAxisRanges& ranges) {
  if (ranges.largest_density <= 1.08 * ranges.linear_top) return "";
  return fmt::format("spike up to {:.3g}", ranges.largest_density);
}

MarginalAxisRanges density_axis_ranges(std::span<const DrawnDensityCurve> curves) {
  DensityAxisExtent linear, logarithmic;
  double linear_top = 0, largest_density = 0, largest_difference = 0;
  double least_difference = std::numeric_limits<double>::infinity(),
         least_density = least_difference;
  for (const auto& drawn : curves) {
    const results::DensityCurve* curve = drawn.curve;
    const std::vector<bool> has_full_width = drawn.undivided_bin_flags();
    double peak = 0;
    for (std::size_t k = 0; k < curve->density.size(); ++k) {
      const double p = curve->density[k];
      if (!std::isfinite(p)) continue;
      largest_density = std::max(largest_density, p);
      least_density = std::min(least_density, std::max(p, 0.0));
      if (has_full_width[k]) peak = std::max(peak, p);
    }
    linear_top = std::max(linear_top, peak);
    for (std::size_t k = 0; k < curve->density.size(); ++k) {
      if (curve->density[k] > kVisibleFraction * peak) linear.include(curve->abscissa[k]);
      if (curve->density[k] > kSmallestDrawnDensity) logarithmic.include(curve->abscissa[k]);
    }
    double peak_difference = 0;
    const bool has_same_bins = drawn.difference.abscissa == curve->abscissa;
    for (std::size_t k = 0; k < drawn.difference.values.size(); ++k) {
      if (has_same_bins && !has_full_width[k]) continue;
      for (const auto* values :
           {&drawn.difference.values, &drawn.difference.lower, &drawn.difference.upper}) {
        if (k >= values->size() || !std::isfinite((*values)[k])) continue;
        peak_difference = std::max(peak_difference, std::abs((*values)[k]));
      }
    }
    largest_difference = std::max(largest_difference, peak_difference);
    if (peak_difference > 0) least_difference = std::min(least_difference, peak_difference);
    if (curve->variable == transform::StateVariable::y)
      include_ends_of_bins(*curve, peak, linear, logarithmic);
  }
  return {.linear_from = linear.from,
          .linear_to = linear.to,
          .logarithmic_from = logarithmic.from,
          .logarithmic_to = logarithmic.to,
          .linear_top = linear_top,
          .largest_density = largest_density,
          .least_density = std::min(least_density, largest_density),
          .largest_difference = largest_difference,
          .least_difference = std::min(least_difference, largest_difference)};
}

}  // namespace fpkcheck::report
