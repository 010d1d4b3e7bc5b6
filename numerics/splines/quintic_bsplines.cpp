#include "numerics/splines/quintic_bsplines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::numerics {

QuinticBSplines::QuinticBSplines(std::vector<double> knots)
    : knots_(std::move(knots)), breaks_(knots_) {
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
  for (int k = 0; k < size(); ++k) {
    if (k >= kDegree && knots_[k] < knots_[k + 1]) first_.push_back(k - kDegree);
  }
}

QuinticBSplines::BasisValuesAndSlopes QuinticBSplines::values_and_slopes(double x) const {
  const double inside = std::clamp(x, begin(), end());
  const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, inside);
  const int span = static_cast<int>(after - breaks_.begin()) - 1;
  BasisValuesAndSlopes values{.first = first_[span], .value = {1}, .slope = {}};
  const int last = values.first + kDegree;  // index of the last knot at the beginning of the span
  // Cox-de Boor recursion: after step p, value[l] is the value of the B-spline of degree p with the
  // index last - p + l.
  std::array<double, kDegree + 1>& b = values.value;
  for (int p = 1; p <= kDegree; ++p) {
    double saved = 0;
    for (int l = 0; l < p; ++l) {
      const double low = knots_[last - p + 1 + l], high = knots_[last + 1 + l];
      const double share = b[l] / (high - low);
      // The slope of a B-spline of degree p is p times the difference of two neighbouring B-splines
      // of degree p - 1, each divided by the width of its support.
      if (p == kDegree && inside == x) {
        values.slope[l] -= p * share;
        values.slope[l + 1] += p * share;
      }
      b[l] = saved + (high - inside) * share;
      saved = (inside - low) * share;
    }
    b[p] = saved;
  }
  return values;
}

std::array<double, QuinticBSplines::kDegree + 1> QuinticBSplines::second_derivatives(
    double x) const {
  std::array<double, kDegree + 1> result{};
  if (x < begin() || x > end()) return result;
  const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, x);
  const int last = first_[after - breaks_.begin() - 1] + kDegree;
  // The recursion of values_and_slopes() gives second derivatives if the slope formula replaces the
  // value formula for the last two degrees.
  std::array<double, kDegree + 1> b{1};
  for (int p = 1; p <= kDegree; ++p) {
    double saved = 0;
    for (int l = 0; l < p; ++l) {
      const double low = knots_[last - p + 1 + l], high = knots_[last + 1 + l];
      const double share = b[l] / (high - low);
      const bool differs = p >= kDegree - 1;
      b[l] = saved + (differs ? -p : high - x) * share;
      saved = (differs ? p : x - low) * share;
    }
    b[p] = saved;
  }
  return b;
}

std::vector<double> QuinticBSplines::coefficients_of_monomial(int power) const {
  constexpr std::array<double, kDegree + 1> kBinomials{1, 5, 10, 10, 5, 1};
  std::vector<double> coefficients;
  for (int i = 0; i < size(); ++i) {
    std::array<double, kDegree + 1> symmetric{
        1};  // elementary symmetric polynomials of the five inner knots
    for (int k = 1; k <= kDegree; ++k) {
      for (int p = kDegree; p > 0; --p) symmetric[p] += knots_[i + k] * symmetric[p - 1];
    }
    coefficients.push_back(symmetric[power] / kBinomials[power]);
  }
  return coefficients;
}

namespace {

/// Returns spline knots at 0 and at the positive breaks `side`. If `both` is true, the mirror
/// images of the breaks are also spline knots.
std::vector<double> mirrored_knots(const std::vector<double>& side, bool both, int multiplicity) {
  const double end = side.back();
  std::vector<double> knots;
  const auto add = [&](double at, int times) { knots.insert(knots.end(), times, at); };
  if (both) {
    for (auto at = side.rbegin(); at != side.rend(); ++at) add(-*at, *at == end ? 6 : 1);
  }
  add(0, both ? multiplicity : 6);
  for (const double at : side) add(at, at == end ? 6 : 1);
  return knots;
}

}  // namespace

std::vector<double> knots_from_breaks(const std::vector<double>& breaks, int multiplicity) {
  std::vector<double> knots;
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const bool end = k == 0 || k + 1 == breaks.size();
    knots.insert(knots.end(), end ? 6 : breaks[k] == 0 ? multiplicity : 1, breaks[k]);
  }
  return knots;
}

std::vector<double> graded_knots(double begin, double end, double uniform_until, int cells,
                                 int multiplicity, int shrinking_cells) {
  constexpr double kShrink = 1.25;
  const int half = begin < 0 ? cells / 2 : cells;  // number of cells on each side of 0
  const int outer = std::max(1, half / 7), inner = half - outer - shrinking_cells;
  // Sum of the powers kShrink^-1 .. kShrink^-shrinking_cells, the widths of the shrinking cells in
  // units of a full cell width.
  const double shrunk = (1 - std::pow(kShrink, -shrinking_cells)) / (kShrink - 1);
  const double width = uniform_until / (inner + shrunk);
  const auto end_position = [&](double factor) {
    double at = uniform_until, step = width;
    for (int k = 0; k < outer; ++k) at += step *= factor;
    return at;
  };
  double highest = 1;
  while (end_position(highest) < end) highest *= 2;
  const double factor =
      bracketed_root([&](double trial) { return end_position(trial) - end; }, 0.0, highest);
  std::vector<double> side;  // positive distinct knots, increasing
  for (int k = shrinking_cells; k > 0; --k) {
    side.push_back((side.empty() ? 0 : side.back()) + width * std::pow(kShrink, -k));
  }
  const double uniform_begin = side.empty() ? 0 : side.back();
  for (int k = 1; k <= inner; ++k) side.push_back(uniform_begin + k * width);
  double step = width;
  for (int k = 1; k < outer; ++k) side.push_back(side.back() + (step *= factor));
  side.push_back(end);
  return mirrored_knots(side, begin < 0, multiplicity);
}

}  // namespace fpkcheck::numerics
