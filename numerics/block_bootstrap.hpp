#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Block bootstrap: sampling errors of averages over a stationary sequence of correlated numbers.
/// Blocks of consecutive numbers are drawn at random with replacement; blocks longer than the
/// correlation time preserve the correlations (Lahiri, Resampling Methods for Dependent Data, 2003).
namespace fpkcheck::numerics {

/// Returns the block length that minimises the mean square error of the bootstrap variance of the
/// mean, by Politis and White, Econometric Reviews 23 (2004) 53, with the correction of Patton,
/// Politis and White, Econometric Reviews 28 (2009) 372:
///
///     b = (2 G^2 / D)^(1/3) n^(1/3),   G = sum_k w(k/M) |k| R(k),   D = 4/3 (sum_k w(k/M) R(k))^2,
///
/// with the autocovariances R(k), |k| <= M, and the flat-top window w of half-width M. Beyond the
/// lag M/2 the autocorrelations are insignificant. Returns nullopt if no lag up to a tenth of the
/// sequence has this property.
/// @pre the sequence is not empty
std::optional<double> bootstrap_block_length(std::span<const double> sequence);

/// Averages of several quantities over consecutive blocks of a sequence.
struct BlockAverages {
  std::size_t quantity_count;
  std::vector<double> averages;  ///< row-major, shape (blocks, quantity_count)

  std::size_t block_count() const { return averages.size() / quantity_count; }
};

/// Returns the averages of all quantities in `replicate_count` bootstrap replicates. A replicate is
/// the average over block_count() blocks, drawn with replacement; a fixed seed makes the replicates
/// reproducible.
/// @return row-major, shape (replicate_count, quantity_count)
/// @pre at least one block
std::vector<double> bootstrap_replicates(const BlockAverages& blocks, std::size_t replicate_count);

}  // namespace fpkcheck::numerics
