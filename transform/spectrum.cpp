#include "transform/spectrum.hpp"

#include <cassert>
#include <cstddef>

namespace fpkcheck::transform {

std::optional<SpectralPeak> find_spectral_peak(const std::vector<double>& frequencies,
                                               const std::vector<double>& density) {
  assert(frequencies.size() == density.size());
  std::size_t top = 0;
  for (std::size_t k = 1; k + 1 < density.size(); ++k) {
    const bool is_maximum = density[k] > density[k - 1] && density[k] >= density[k + 1];
    if (is_maximum && (top == 0 || density[k] > density[top])) top = k;
  }
  if (top == 0) return std::nullopt;
  // The spectral peak is the vertex of the interpolating parabola in Newton's form.
  const double a = frequencies[top - 1], b = frequencies[top], c = frequencies[top + 1];
  const double slope_ab = (density[top] - density[top - 1]) / (b - a);
  const double slope_bc = (density[top + 1] - density[top]) / (c - b);
  const double curvature = (slope_bc - slope_ab) / (c - a);
  SpectralPeak peak{.frequency = (a + b) / 2 - slope_ab / (2 * curvature)};
  peak.density = density[top - 1] + slope_ab * (peak.frequency - a) +
                 curvature * (peak.frequency - a) * (peak.frequency - b);

  // Returns the frequency at which the spectral density falls to half of the peak, in one direction
  // from the peak.
  const auto half_frequency = [&](int direction) -> std::optional<double> {
    for (std::size_t k = top; k != (direction < 0 ? 0 : density.size() - 1);) {
      const std::size_t next = direction < 0 ? k - 1 : k + 1;
      if (density[next] < peak.density / 2) {
        const double part = (density[k] - peak.density / 2) / (density[k] - density[next]);
        return frequencies[k] + part * (frequencies[next] - frequencies[k]);
      }
      k = next;
    }
    return std::nullopt;
  };
  const auto low = half_frequency(-1), high = half_frequency(1);
  if (low && high) peak.half_width = (*high - *low) / 2;
  return peak;
}

}  // namespace fpkcheck::transform
