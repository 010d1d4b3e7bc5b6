#pragma once

/// Criteria: numerical limits for the statements of the paper. Each limit has a reason that is
/// independent of the results.
namespace fpkcheck::paper {

/// Largest L1 distance between densities that agree: the default accuracy required of closures
/// (`--accuracy`). The probability of every set is then within 0.01.
inline constexpr double kAgreementL1 = 0.02;

/// Largest mean |log10 p - log10 MCS| between tails that agree, in decades (a factor of 1.6): the
/// resolution of the paper's own simulation. At a density of 1e-5, the far end of the tail here,
/// about ten of its 1e7 samples fall into a bin of width 0.1; the 95 % interval is then +-0.6 of
/// the density. On the logarithmic axes of the paper's figures, from 1 to 1e-6, the limit is a
/// thirtieth of the height.
inline constexpr double kAgreementInTail = 0.2;

/// Largest L1 distance between two bin representations of the same Gaussian: they differ by
/// rounding and quadrature alone.
inline constexpr double kSameGaussianL1 = 1e-9;

/// Largest error of the reference, as a fraction of kAgreementL1, with which claims are judged.
inline constexpr double kMaxReferenceErrorFraction = 0.1;

}  // namespace fpkcheck::paper
