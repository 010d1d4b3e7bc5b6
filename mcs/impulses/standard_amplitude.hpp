#pragma once

#include "numerics/simd/elementary.hpp"

namespace fpkcheck::problem {
struct ExponentialLaw;
struct GammaLaw;
struct GaussianLaw;
struct LaplaceLaw;
struct TabulatedLaw;
struct TwoPointLaw;
struct UniformLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::mcs {

/// How an amplitude of the law is drawn that has mean 0 and width() 1: `of` two independent numbers
/// of (0, 1), u with more digits than w (Uniforms). A further law of problem::ImpulseLaw is drawn
/// by one more of these, in its place of DrawnLaws: a formula, or DrawnFromPieces. (The laws
/// themselves, with all that they include, are kept out of what is compiled for several
/// instructions.)
template <class Law>
struct StandardAmplitude;

/// Box and Muller: the cosine of a random angle is the sine of one within a quarter turn.
template <>
struct StandardAmplitude<problem::GaussianLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real of(const Real& u, const Real& w) {
    return simd::square_root(-2.0 * simd::logarithm(u)) *
           simd::sine_of_quarter_turns(2.0 * w - 1.0);
  }
};

template <>
struct StandardAmplitude<problem::LaplaceLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real of(const Real& u, const Real& w) {
    const Real size = -simd::logarithm(u);
    return simd::select(2.0 * w - 1.0 < 0.0, -size, size);
  }
};

template <>
struct StandardAmplitude<problem::TwoPointLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real of(const Real&, const Real& w) {
    return simd::select(2.0 * w - 1.0 < 0.0, simd::all_lanes<Real>(-1.0),
                        simd::all_lanes<Real>(1.0));
  }
};

template <>
struct StandardAmplitude<problem::UniformLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real of(const Real& u, const Real&) {
    return 2.0 * u - 1.0;
  }
};

template <>
struct StandardAmplitude<problem::ExponentialLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real of(const Real& u, const Real&) {
    return -1.0 - simd::logarithm(u);
  }
};

/// Of a law that says its standardised_quantile instead, or has atoms or a density linear in
/// pieces.
struct DrawnFromPieces {};
template <>
struct StandardAmplitude<problem::GammaLaw> : DrawnFromPieces {};
template <>
struct StandardAmplitude<problem::TabulatedLaw> : DrawnFromPieces {};

template <class... Laws>
struct LawList {};

/// The laws in the order of problem::ImpulseLaw::Kind.
using DrawnLaws =
    LawList<problem::GaussianLaw, problem::LaplaceLaw, problem::TwoPointLaw, problem::UniformLaw,
            problem::ExponentialLaw, problem::GammaLaw, problem::TabulatedLaw>;

}  // namespace fpkcheck::mcs
