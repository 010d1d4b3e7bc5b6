#pragma once

#include <memory>

#include "mcs/impulses/piecewise_quantile_function.hpp"

namespace fpkcheck::problem {
class ImpulseTrain;
}

namespace fpkcheck::mcs {

/// Excitation by a sequence of impulses: arrival times and amplitude law.
struct Excitation {
  enum class Arrivals {
    poisson,  ///< exponentially distributed waiting times with mean `interval`
    /// Equal waiting times `interval`, except for a random first waiting time
    even
  };

  Arrivals arrivals;
  double interval;
  int law;  ///< amplitude law, as an index of AmplitudeLaws
  double mean;
  /// Scale of the amplitude, width() of the amplitude law; negative for a mirrored law
  double width;

  /// Mean power of the impulses, lambda E[Y^2] / 2, since E[y'] = 0. For evenly spaced kicks with a
  /// nonzero mean, `power` has an error of first order in the interval.
  double power;
  /// Expected work per unit time for any motion, where the work is the sum of (b Y - shift) v +
  /// Y^2/2 over all impulses, with the factor b(y) of parametric impulses (b = 1 without a factor).
  /// The shift is 0 for Poisson impulses, since the mean of v at Poisson impulses is 0. The shift
  /// is E[Y] for evenly spaced kicks, since the mean of v at evenly spaced kicks is not 0.
  double shift, work;
  /// Quantile function of the law with mean 0 and width 1, for laws with DrawnFromQuantileFunction;
  /// null for other laws
  std::shared_ptr<const PiecewiseQuantileFunction> pieces = {};
};

Excitation poisson_excitation(const problem::ImpulseTrain& impulses);

/// Returns Gaussian white noise with the mean and intensity of the impulses. The white noise is
/// approximated by kicks at the interval h with amplitudes N(lambda E[Y] h, lambda E[Y^2] h).
Excitation white_noise_excitation(const problem::ImpulseTrain& impulses, double interval);

/// Returns impulses at unit intervals with standard normal amplitudes, which NoiseSource and the
/// initial states use as random numbers.
Excitation standard_normal_impulses();

}  // namespace fpkcheck::mcs
