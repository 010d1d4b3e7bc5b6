#pragma once

#include <optional>
#include <span>

#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// The statistical test of whether two solutions of the same problem agree. All tables and
/// sentences use this test.
namespace fpkcheck::compare {

/// Significance level of the test over both densities: the probability that sampling errors alone
/// make a pair of solutions disagree.
inline constexpr double kAgreementSignificance = 1e-3;

/// Critical L1 distance of two marginal densities that differ by sampling errors only, at the
/// significance level kAgreementSignificance. Each of the two marginals is tested at half the
/// significance level (Bonferroni). The sampling errors are Gaussian vectors, the L1 distance is a
/// norm, and N is standard normal. Hence P(L1 <= t q) >= P(|N| <= t 2.576) for t >= 1, with q the
/// 99 % quantile of the L1 distance (the S-inequality: Latala, Oleszkiewicz, Ann. Probab. 27 (1999)
/// 1922). P(|N| <= 3.481) = 1 - kAgreementSignificance / 2, and 3.481 / 2.576 = 1.351. Hence
/// 1.351 q is an upper bound of the critical distance.
/// @param quantile_99 99 % quantile q of the L1 distance
double critical_sampling_l1_distance(double quantile_99);

/// 99 % quantile of the L1 sampling error of a marginal. If a solution states only the expected L1
/// sampling error, the result is twice the expected value: the L1 errors of single runs nearly
/// reach twice the expected value. Empty if the solution states neither.
std::optional<double> sampling_l1_quantile_99(const transform::SamplingError& sampling,
                                              transform::Variable variable);

/// Critical L1 distance of two solutions in one marginal density: the largest distance that the
/// errors of both solutions explain. The critical distance is a sum of two terms: the critical
/// distance under independent sampling errors at kAgreementSignificance, and the error estimates of
/// both solutions times kErrorSafetyFactor. The result is empty if neither solution has a sampling
/// error or an error estimate. Sampling errors over smooth bins are far smaller; there the result
/// is empty if either solution has neither.
/// @param over_smooth_bins whether the distance is over smooth bins
std::optional<double> critical_l1_distance(const transform::Solution& first,
                                           const transform::Solution& second,
                                           transform::Variable variable, bool over_smooth_bins);

/// Whether the errors of two solutions explain their L1 distances in both marginal densities. In a
/// marginal without a distance or without an error estimate the solutions count as agreeing.
bool has_agreement(const transform::Solution& first, const transform::Solution& second,
                   std::span<const PairDistances> pairs);

}  // namespace fpkcheck::compare
