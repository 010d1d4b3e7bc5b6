#include "dual/spline/knot_splines.hpp"

#include <algorithm>
#include <utility>

namespace fpkcheck::dual {

KnotSplines::KnotSplines(std::vector<double> knots) : knots_(std::move(knots)), breaks_(knots_) {
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
  for (int k = 0; k < size(); ++k) {
    if (k >= kDegree && knots_[k] < knots_[k + 1]) first_.push_back(k - kDegree);
  }
}

KnotSplines::Values KnotSplines::at(double x) const {
  const double inside = std::clamp(x, begin(), end());
  const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, inside);
  const int span = static_cast<int>(after - breaks_.begin()) - 1;
  Values values{.first = first_[span], .value = {1}, .slope = {}};
  const int last = values.first + kDegree;  // the last knot at the beginning of the span
  // Cox and de Boor: value[l] is function last - p + l of degree p.
  std::array<double, kDegree + 1>& b = values.value;
  for (int p = 1; p <= kDegree; ++p) {
    double carried = 0;
    for (int l = 0; l < p; ++l) {
      const double low = knots_[last - p + 1 + l], high = knots_[last + 1 + l];
      const double share = b[l] / (high - low);
      // Of the fifth degree the slopes are p (share before - share).
      if (p == kDegree && inside == x) {
        values.slope[l] -= p * share;
        values.slope[l + 1] += p * share;
      }
      b[l] = carried + (high - inside) * share;
      carried = (inside - low) * share;
    }
    b[p] = carried;
  }
  return values;
}

std::vector<double> KnotSplines::power(int power) const {
  constexpr std::array<double, kDegree + 1> kChoices{1, 5, 10, 10, 5, 1};
  std::vector<double> coefficients;
  for (int i = 0; i < size(); ++i) {
    std::array<double, kDegree + 1> symmetric{1};  // elementary symmetric polynomials
    for (int k = 1; k <= kDegree; ++k) {
      for (int p = kDegree; p > 0; --p) symmetric[p] += knots_[i + k] * symmetric[p - 1];
    }
    coefficients.push_back(symmetric[power] / kChoices[power]);
  }
  return coefficients;
}

std::vector<double> even_knots(double begin, double end, int cells, int repetitions) {
  std::vector<double> knots(KnotSplines::kDegree, begin);
  const double width = (end - begin) / cells;
  for (int k = 0; k <= cells; ++k) {
    double at = k == cells ? end : begin + k * width;
    const bool zero = k > 0 && k < cells && at > -1e-9 * width && at < 1e-9 * width;
    if (zero) at = 0;
    knots.insert(knots.end(), zero ? repetitions : 1, at);
  }
  knots.insert(knots.end(), KnotSplines::kDegree, end);
  return knots;
}

}  // namespace fpkcheck::dual
