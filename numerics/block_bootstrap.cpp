#include "numerics/block_bootstrap.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fpkcheck::numerics {
namespace {

// Constants of Politis and White (2004), section 3.2: an autocorrelation is insignificant below
// kSignificance sqrt(log10(n) / n), if this holds for max(kMinRun, sqrt(log10 n)) successive lags.
constexpr double kSignificance = 2;
constexpr std::size_t kMinRun = 5;
// Blocks of a tenth of the sequence give ten blocks; sampling errors from fewer blocks are
// meaningless.
constexpr std::size_t kMinBlocks = 10;

double mean_of(std::span<const double> sequence) {
  double sum = 0;
  for (const double value : sequence) sum += value;
  return sum / static_cast<double>(sequence.size());
}

// Returns the autocovariance R(k) = sum_i (x_i - mean) (x_{i+k} - mean) / n.
double autocovariance(std::span<const double> centred, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = 0; i + lag < centred.size(); ++i) sum += centred[i] * centred[i + lag];
  return sum / static_cast<double>(centred.size());
}

// The flat-top window w(t): 1 up to t = 1/2, then linear to 0 at t = 1.
double flat_top_window(double t) { return std::clamp(2 * (1 - t), 0.0, 1.0); }

}  // namespace

std::optional<double> bootstrap_block_length(std::span<const double> sequence) {
  assert(!sequence.empty());
  const double mean = mean_of(sequence), n = static_cast<double>(sequence.size());
  std::vector<double> centred;
  centred.reserve(sequence.size());
  for (const double value : sequence) centred.push_back(value - mean);
  std::vector<double> covariances{autocovariance(centred, 0)};
  if (!(covariances[0] > 0)) return 1;
  const double limit = kSignificance * std::sqrt(std::log10(n) / n) * covariances[0];
  const std::size_t run_needed =
      std::max(kMinRun, static_cast<std::size_t>(std::ceil(std::sqrt(std::log10(n)))));
  std::size_t run = 0;
  while (run < run_needed) {
    if (covariances.size() > sequence.size() / kMinBlocks) return std::nullopt;
    covariances.push_back(autocovariance(centred, covariances.size()));
    run = std::abs(covariances.back()) < limit ? run + 1 : 0;
  }
  const std::size_t last_significant_lag = covariances.size() - 1 - run_needed;
  const std::size_t window = std::max<std::size_t>(2 * last_significant_lag, 1);
  while (covariances.size() <= window) {
    covariances.push_back(autocovariance(centred, covariances.size()));
  }
  double lag_sum = 0, spectrum_at_zero = covariances[0];
  for (std::size_t k = 1; k <= window; ++k) {
    const double weighted =
        2 * covariances[k] * flat_top_window(static_cast<double>(k) / static_cast<double>(window));
    lag_sum += static_cast<double>(k) * weighted;
    spectrum_at_zero += weighted;
  }
  const double d = 4 * spectrum_at_zero * spectrum_at_zero / 3;
  const double longest = n / static_cast<double>(kMinBlocks);
  if (!(d > 0)) return longest;
  return std::clamp(std::cbrt(2 * lag_sum * lag_sum / d * n), 1.0, longest);
}

std::vector<double> bootstrap_replicates(const BlockAverages& blocks, std::size_t replicate_count) {
  assert(blocks.block_count() > 0);
  constexpr std::uint64_t kSeed = 20240501;  // arbitrary
  boost::random::mt19937_64 engine(kSeed);
  boost::random::uniform_int_distribution<std::size_t> draw(0, blocks.block_count() - 1);
  const std::size_t quantities = blocks.quantity_count;
  std::vector<double> replicates(replicate_count * quantities, 0.0);
  for (std::size_t r = 0; r < replicate_count; ++r) {
    double* const replicate = replicates.data() + r * quantities;
    for (std::size_t k = 0; k < blocks.block_count(); ++k) {
      const double* const block = blocks.averages.data() + draw(engine) * quantities;
      for (std::size_t q = 0; q < quantities; ++q) replicate[q] += block[q];
    }
    for (std::size_t q = 0; q < quantities; ++q) {
      replicate[q] /= static_cast<double>(blocks.block_count());
    }
  }
  return replicates;
}

}  // namespace fpkcheck::numerics
