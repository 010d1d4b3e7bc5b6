#pragma once

/// What words of the paper mean in numbers, each for a reason that does not depend on what comes out.
namespace fpkcheck::paper {

/// Densities agree up to this L1: the accuracy that closures are held to everywhere (`--accuracy`);
/// no set of values then has a probability that is off by more than 0.01.
inline constexpr double kAgreementL1 = 0.02;

/// Tails agree up to this mean |log10 p - log10 MCS|, in decades (a factor of 1.6): what the paper's
/// own simulation can tell apart. Of its 1e7 samples about ten fall into a bin of width 0.1 where the
/// density is 1e-5, the far end of the tail here, and that is a 95 % interval of +-0.6 of the density.
/// On a logarithmic axis from 1 to 1e-6, as in the figures, it is a thirtieth of the height.
inline constexpr double kAgreementInTail = 0.2;

/// Two ways to write down the same Gaussian: their bins differ by rounding and quadrature alone.
inline constexpr double kSameGaussianL1 = 1e-9;

/// A reference that is off by more than this part of kAgreementL1 cannot decide.
inline constexpr double kReferencePart = 0.1;

}  // namespace fpkcheck::paper
