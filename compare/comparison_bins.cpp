#include "compare/comparison_bins.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "problem/equivalent_linearisation.hpp"
#include "problem/motion_scales.hpp"

namespace fpkcheck::compare {
namespace {

// The bins of y' are a tenth of a standard deviation wide, the bins of y a twentieth of a standard
// deviation. A marginal density is nearly linear over a bin of a tenth of a standard deviation.
constexpr int kBins = 140;
constexpr int kDivisions = 3;
constexpr double kDivisionRatio = 4;

// Returns whether the marginal densities are unbounded at the equilibrium on a wall at y = 0. The
// marginal densities are unbounded if the oscillator decays to rest before the next impulse
// (problem/equivalent_linearisation.hpp).
bool has_unbounded_marginals(const problem::Problem& problem, const problem::MotionScales& scales) {
  return problem::has_equivalent_linearisation(problem) &&
         problem::impulses_per_decay_time(problem, scales) < 1;
}

std::vector<double> make_uniform_bins(double from, double to) {
  std::vector<double> edges;
  for (int k = 0; k <= kBins; ++k) edges.push_back(from + (to - from) * k / kBins);
  edges.back() = to;
  return edges;
}

// Returns the edges of bins over [0, end], or over [-end, end] if `symmetric`. The edges of
// symmetric bins are pairs of exactly opposite numbers. The middle edge of symmetric bins is
// exactly 0, since p(y, y') at the wall is discontinuous at y' = 0.
std::vector<double> make_divided_bins(double end, bool symmetric, int divisions) {
  std::vector<double> edges;
  const double width = end * (symmetric ? 2 : 1) / kBins;
  const auto divide = [&](int side, int d) {
    edges.push_back(side * width / std::pow(kDivisionRatio, d));
  };
  for (int k = 0; k <= kBins; ++k) {
    const int steps = symmetric ? 2 * k - kBins : k;
    for (int d = 1; steps == 0 && symmetric && d <= divisions; ++d) divide(-1, d);
    edges.push_back(end * steps / kBins);
    for (int d = divisions; steps == 0 && d >= 1; --d) divide(1, d);
  }
  return edges;
}

std::vector<double> remove_divisions(const std::vector<double>& edges, int divisions) {
  const auto zero = std::ranges::find(edges, 0.0) - edges.begin();
  std::vector<double> even;
  for (std::ptrdiff_t k = 0; k < std::ssize(edges); ++k) {
    const auto from_zero = std::abs(k - zero);
    if (from_zero == 0 || from_zero > divisions) even.push_back(edges[static_cast<std::size_t>(k)]);
  }
  return even;
}

}  // namespace

ComparisonBins comparison_bins(const problem::Problem& problem) {
  const auto scales = problem::motion_scales(problem);
  const bool divided = has_unbounded_marginals(problem, scales);
  const int divisions = divided ? kDivisions : 0;
  return {divided ? make_divided_bins(scales.y_high, false, divisions)
                  : make_uniform_bins(scales.y_low, scales.y_high),
          make_divided_bins(scales.v_high, true, divisions), divisions};
}

const std::vector<double>& comparison_bin_edges(const ComparisonBins& axes,
                                                transform::StateVariable variable) {
  return variable == transform::StateVariable::y ? axes.y_edges : axes.v_edges;
}

ComparisonBins undivided_comparison_bins(const ComparisonBins& axes) {
  return {remove_divisions(axes.y_edges, axes.divisions),
          remove_divisions(axes.v_edges, axes.divisions)};
}

transform::Marginal merge_divided_bins(const ComparisonBins& axes,
                                       transform::StateVariable variable,
                                       const transform::Marginal& marginal) {
  if (axes.divisions == 0) return marginal;
  transform::Marginal even{
      comparison_bin_edges(undivided_comparison_bins(axes), variable), {}, {}, {}};
  // The squared half-widths of the confidence intervals of the parts of a divided bin are added.
  const auto interval_half_width = [&](const std::vector<double>& ends, std::size_t from,
                                       std::size_t to) {
    double sum = 0;
    for (std::size_t k = from; k < to; ++k) {
      sum += std::pow((ends[k] - marginal.density[k]) * marginal.bin_width(k), 2);
    }
    return std::sqrt(sum);
  };
  std::size_t part = 0;
  for (std::size_t b = 0; b + 1 < even.edges.size(); ++b) {
    const std::size_t first = part;
    const double width = even.bin_width(b);
    double mass = 0;
    for (; part < marginal.size() && marginal.edges[part] < even.edges[b + 1]; ++part) {
      mass += marginal.density[part] * marginal.bin_width(part);
    }
    even.density.push_back(mass / width);
    if (marginal.lower.empty()) continue;
    even.lower.push_back((mass - interval_half_width(marginal.lower, first, part)) / width);
    even.upper.push_back((mass + interval_half_width(marginal.upper, first, part)) / width);
  }
  return even;
}

}  // namespace fpkcheck::compare
