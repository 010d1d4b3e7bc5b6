#pragma once

#include <optional>
#include <span>

#include "compare/pairs.hpp"
#include "transform/solution.hpp"

/// The one test of whether two solutions of the same problem agree, for every table and sentence.
namespace fpkcheck::compare {

/// Probability with which chance alone makes one pair of solutions disagree: the level of the test of
/// both densities together.
inline constexpr double kAgreementLevel = 1e-3;

/// The largest L1 distance of one density that chance explains at kAgreementLevel. Each of the two
/// densities is tested at half the level (Bonferroni). The errors are Gaussian vectors and L1 is a
/// norm, so that P(L1 <= t q) >= P(|N| <= t 2.576) for t >= 1 where q is the quantile of 99 % (the S-inequality:
/// Latala, Oleszkiewicz, Ann. Probab. 27 (1999) 1922): 1.351 q bounds the quantile sought.
/// @param in_99 what 99 runs of 100 stay below
double largest_by_chance(double in_99);

/// What 99 runs of 100 stay below; twice the expectation where that alone is stated (single runs reach
/// nearly that).
std::optional<double> most_by_chance(const transform::SamplingError& sampling,
                                     transform::Variable variable);

/// The largest L1 distance of one density that the errors of two solutions explain: their errors by
/// chance, which are independent, at kAgreementLevel, and their stated errors times kErrorBand. Nothing
/// where neither solution states an error; over smooth bins, whose errors by chance are far below
/// others, where one of them states none.
/// @param smooth whether the distance is over smooth bins
std::optional<double> largest_explained(const transform::Solution& one,
                                        const transform::Solution& other,
                                        transform::Variable variable, bool smooth);

/// Whether the errors of two solutions explain their distances in both densities, where distances and
/// errors are known.
bool agree(const transform::Solution& one, const transform::Solution& other,
           std::span<const PairDistances> pairs);

}  // namespace fpkcheck::compare
