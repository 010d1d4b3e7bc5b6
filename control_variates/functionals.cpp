#include "control_variates/functionals.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::control_variates {
namespace {

double one(double) { return 1; }

std::function<double(double)> power(int n) {
  return [n](double x) { return std::pow(x, n); };
}

std::function<double(double)> smooth_bin(const transform::SmoothBins& bins, int b) {
  return [bins, b](double x) {
    return transform::cardinal_cubic_spline((x - bins.first) / bins.spacing - b);
  };
}

}  // namespace

std::vector<backward::SeparableFunction> Functionals::integrands() const {
  std::vector<backward::SeparableFunction> all;
  for (const auto& [p, q] : kMoments) all.push_back({power(p), power(q)});
  for (int b = 0; b < y_bins.count; ++b) all.push_back({smooth_bin(y_bins, b), one});
  for (int b = 0; b < v_bins.count; ++b) all.push_back({one, smooth_bin(v_bins, b)});
  return all;
}

std::vector<double> Functionals::stream_means(const mcs::StreamDeposit& stream) const {
  std::vector<double> all;
  for (const auto& [p, q] : kMoments) {
    const auto at = std::ranges::find(mcs::kPowers, std::pair{p, q}) - mcs::kPowers.begin();
    all.push_back(stream.powers[static_cast<std::size_t>(at)] / stream.samples);
  }
  const auto put = [&](const std::vector<double>& sums, int count) {
    for (int b = 0; b < count; ++b) {
      all.push_back(sums[static_cast<std::size_t>(b + mcs::DepositedSums::kBinOffset)] /
                    stream.samples);
    }
  };
  put(stream.sums.y_bins, y_bins.count);
  put(stream.sums.v_bins, v_bins.count);
  return all;
}

}  // namespace fpkcheck::control_variates
