#pragma once

#include "numerics/simd/elementary_functions.hpp"

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

/// Draws an amplitude of the law with mean 0 and width_parameter() 1 from two independent uniform
/// numbers u and w of (0, 1); u has more random digits than w. The specialisation of
/// StandardAmplitude for each law of problem::ImpulseLaw contains a formula or derives from
/// AmplitudeByQuantileFunction. standard_amplitude.hpp only declares the types of the amplitude
/// laws, since the headers of the amplitude laws must not be compiled for several instruction sets.
template <class Law>
struct StandardAmplitude;

/// Box-Muller transform with the sine of an angle between -90 and 90 degrees, instead of the cosine
/// of an angle on the full turn. The sine and the cosine of a uniform random angle have equal
/// distributions.
template <>
struct StandardAmplitude<problem::GaussianLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real draw_standard_amplitude(const Real& u, const Real& w) {
    return simd::square_root(-2.0 * simd::logarithm(u)) *
           simd::sine_of_quarter_turns(2.0 * w - 1.0);
  }
};

template <>
struct StandardAmplitude<problem::LaplaceLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real draw_standard_amplitude(const Real& u, const Real& w) {
    const Real size = -simd::logarithm(u);
    return simd::select(2.0 * w - 1.0 < 0.0, -size, size);
  }
};

template <>
struct StandardAmplitude<problem::TwoPointLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real draw_standard_amplitude(const Real&, const Real& w) {
    return simd::select(2.0 * w - 1.0 < 0.0, simd::all_lanes_equal_to<Real>(-1.0),
                        simd::all_lanes_equal_to<Real>(1.0));
  }
};

template <>
struct StandardAmplitude<problem::UniformLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real draw_standard_amplitude(const Real& u, const Real&) {
    return 2.0 * u - 1.0;
  }
};

template <>
struct StandardAmplitude<problem::ExponentialLaw> {
  template <class Real>
  FPKCHECK_INLINE static Real draw_standard_amplitude(const Real& u, const Real&) {
    return -1.0 - simd::logarithm(u);
  }
};

/// Base of StandardAmplitude for laws whose amplitudes are drawn with PiecewiseQuantileFunction.
struct AmplitudeByQuantileFunction {};
template <>
struct StandardAmplitude<problem::GammaLaw> : AmplitudeByQuantileFunction {};
template <>
struct StandardAmplitude<problem::TabulatedLaw> : AmplitudeByQuantileFunction {};

template <class... Laws>
struct AmplitudeLawList {};

/// All amplitude laws, in the order of problem::ImpulseLaw::LawVariant.
using AmplitudeLaws =
    AmplitudeLawList<problem::GaussianLaw, problem::LaplaceLaw, problem::TwoPointLaw,
                     problem::UniformLaw, problem::ExponentialLaw, problem::GammaLaw,
                     problem::TabulatedLaw>;

}  // namespace fpkcheck::mcs
