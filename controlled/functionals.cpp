#include "controlled/functionals.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::controlled {
namespace {

double one(double) { return 1; }

std::function<double(double)> power(int n) {
  return [n](double x) { return std::pow(x, n); };
}

std::function<double(double)> smooth_bin(const mcs::CubicBins& bins, int b) {
  return [bins, b](double x) { return cubic_spline((x - bins.first) / bins.spacing - b); };
}

}  // namespace

double cubic_spline(double t) {
  const double u = std::abs(t), far = std::max(0.0, 2 - u), near = std::max(0.0, 1 - u);
  return (far * far * far - 4 * near * near * near) / 6;
}

double bin_weight(const mcs::CubicBins& bins, int bin, double from) {
  const double t = (from - bins.first) / bins.spacing - bin, u = std::abs(t);
  // int_u^2 M for u >= 0
  const double far = std::max(0.0, 2 - u), near = std::max(0.0, 1 - u);
  const double beyond = (std::pow(far, 4) - 4 * std::pow(near, 4)) / 24;
  return bins.spacing * (t >= 0 ? beyond : 1 - beyond);
}

std::vector<dual::SeparableFunction> Functionals::functions() const {
  std::vector<dual::SeparableFunction> all;
  for (const auto& [p, q] : kMoments) all.push_back({power(p), power(q)});
  for (int b = 0; b < y_bins.count; ++b) all.push_back({smooth_bin(y_bins, b), one});
  for (int b = 0; b < v_bins.count; ++b) all.push_back({one, smooth_bin(v_bins, b)});
  return all;
}

std::vector<double> Functionals::means(const mcs::StreamDeposit& stream) const {
  std::vector<double> all;
  for (const auto& [p, q] : kMoments) {
    const auto at = std::ranges::find(mcs::kPowers, std::pair{p, q}) - mcs::kPowers.begin();
    all.push_back(stream.powers[static_cast<std::size_t>(at)] / stream.samples);
  }
  const auto put = [&](const std::vector<double>& sums, int count) {
    for (int b = 0; b < count; ++b) {
      all.push_back(sums[static_cast<std::size_t>(b + mcs::Deposit::kFrame)] / stream.samples);
    }
  };
  put(stream.sums.y_bins, y_bins.count);
  put(stream.sums.v_bins, v_bins.count);
  return all;
}

}  // namespace fpkcheck::controlled
