#pragma once

#include <optional>
#include <span>

#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

/// Statistical test of whether two solutions of the same problem agree within their errors.
namespace fpkcheck::compare {

/// Significance level of the agreement test of p(y) and p(y'): the probability that sampling errors
/// alone make two solutions disagree.
inline constexpr double kAgreementSignificance = 1e-3;

/// Returns an upper bound, 1.351 times the 99 % quantile, of the critical L1 distance of two
/// marginal densities that differ only by sampling errors. The densities p(y) and p(y') are each
/// tested at half of the significance level kAgreementSignificance (Bonferroni). The sampling
/// errors of a density are Gaussian vectors, and the L1 distance is a norm. The S-inequality
/// (Latala and Oleszkiewicz, Annals of Probability 27 (1999) 1922) gives P(L1 <= t q) >= P(|N| <=
/// 2.576 t) for t >= 1, the 99 % quantile q and a standard normal N. With P(|N| <= 3.481) = 1 -
/// kAgreementSignificance / 2 the factor of the 99 % quantile is t = 3.481 / 2.576 = 1.351.
/// @param quantile_99 99 % quantile q of the L1 distance
double critical_sampling_l1_distance(double quantile_99);

/// Returns the 99 % quantile of the L1 sampling error of a marginal density. If only the expected
/// L1 sampling error is known, the result is twice the expected error, which the errors of single
/// simulations nearly reach. The result is empty if both the 99 % quantile and the expected
/// sampling error are unknown.
std::optional<double> sampling_l1_quantile_99(const transform::MarginalSamplingErrors& sampling,
                                              transform::StateVariable variable);

/// Returns the critical L1 distance of two solutions: the largest distance that the errors of the
/// solutions explain. The critical L1 distance is the sum of two terms: the critical distance for
/// independent sampling errors, and kErrorSafetyFactor times the error estimates of both solutions.
/// The critical L1 distance is empty if neither solution has a sampling error or an error estimate.
/// For distances over smooth bins, whose sampling errors are small, the critical distance is empty
/// unless both solutions have a sampling error or an error estimate.
/// @param over_smooth_bins whether the L1 distance is over smooth bins
std::optional<double> largest_explained_l1_distance(const transform::Solution& first,
                                                    const transform::Solution& second,
                                                    transform::StateVariable variable,
                                                    bool over_smooth_bins);

/// Returns whether the L1 distances of two solutions in p(y) and in p(y') are at most the critical
/// L1 distances. The solutions count as agreeing if an L1 distance or an error estimate is missing.
bool solutions_agree(const transform::Solution& first, const transform::Solution& second,
                     std::span<const SolutionPairDistances> pairs);

}  // namespace fpkcheck::compare
