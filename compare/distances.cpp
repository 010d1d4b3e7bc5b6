#include "compare/distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fpkcheck::compare {
namespace {

using transform::Marginal;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kDecades = 6;
constexpr double kMaxRelativeHalfWidth = 0.5;

void require_same_bins(const Marginal& a, const Marginal& b) {
  if (a.edges != b.edges) throw std::invalid_argument("the densities have different bins");
  for (const Marginal* m : {&a, &b}) {
    const auto fits = [&](const auto& bound) { return bound.empty() || bound.size() == m->size(); };
    if (m->edges.size() != m->size() + 1 || !fits(m->lower) || !fits(m->upper)) {
      throw std::invalid_argument("numbers of bins, averages and intervals of a density differ");
    }
  }
}

bool is_finite(const Marginal& m) {
  return std::ranges::all_of(m.density, [](double p) { return std::isfinite(p); });
}

// Returns the integrand b log(b/a) - b + a of the Kullback-Leibler divergence of densities b and a,
// with its limits for a = 0 and b = 0.
double kullback_leibler_term(double a, double b) {
  if (b == 0) return a;
  return a == 0 ? kInfinity : b * std::log(b / a) - b + a;
}

LogarithmicTailDistance tail_distance(const Marginal& a, const Marginal& b, double from,
                                      double to) {
  LogarithmicTailDistance tail{from, to, 0, 0, 0};
  for (std::size_t k = 0; k < b.size(); ++k) {
    if (b.density[k] < from || b.density[k] >= to) continue;
    if (a.density[k] > 0 && has_narrow_confidence_interval(a, k) &&
        has_narrow_confidence_interval(b, k)) {
      tail.mean_abs += std::abs(std::log10(a.density[k] / b.density[k]));
      ++tail.bins;
    } else {
      ++tail.omitted_bin_count;
    }
  }
  tail.mean_abs = tail.bins > 0 ? tail.mean_abs / tail.bins : kNotANumber;
  return tail;
}

}  // namespace

bool has_narrow_confidence_interval(const Marginal& m, std::size_t bin) {
  if (m.lower.empty() || m.upper.empty()) return true;
  return m.upper[bin] - m.lower[bin] <= 2 * kMaxRelativeHalfWidth * m.density[bin];
}

DensityDistances compute_distances(const Marginal& a, const Marginal& b) {
  require_same_bins(a, b);
  if (!is_finite(a) || !is_finite(b)) {
    return {kNotANumber, kNotANumber, kNotANumber, kNotANumber, kNotANumber, {}};
  }
  DensityDistances d{};
  double squares = 0, root_squares = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double width = a.bin_width(k);
    const double difference = a.density[k] - b.density[k];
    d.l1 += std::abs(difference) * width;
    squares += difference * difference * width;
    d.sup = std::max(d.sup, std::abs(difference));
    const double pa = std::max(a.density[k], 0.0), pb = std::max(b.density[k], 0.0);
    const double root_difference = std::sqrt(pa) - std::sqrt(pb);
    root_squares += root_difference * root_difference * width;
    d.kl += kullback_leibler_term(pa, pb) * width;
  }
  d.l2 = std::sqrt(squares);
  d.hellinger = std::sqrt(root_squares / 2);
  for (int decade = 0; decade < kDecades; ++decade) {
    d.log10_tail.push_back(
        tail_distance(a, b, std::pow(10.0, -decade - 1), std::pow(10.0, -decade)));
  }
  return d;
}

}  // namespace fpkcheck::compare
