#pragma once

#include <memory>

#include "mcs/impulses/piecewise_quantile_function.hpp"

namespace fpkcheck::problem {
class ImpulseTrain;
}

namespace fpkcheck::mcs {

/// Excitation by a sequence of impulses: arrival times and amplitude law.
struct ImpulseProcess {
  enum class Arrivals {
    poisson,  ///< exponentially distributed waiting times with mean `interval`
    /// Waiting times between impulses equal to `interval`, except for a random first waiting time
    even
  };

  Arrivals arrivals;
  double interval;
  int law;  ///< amplitude law, as an index of AmplitudeLaws
  double mean;
  /// Scale of the impulse amplitude, ImpulseLaw::width_parameter(); negative for a mirrored law
  double width;

  /// Mean power lambda E[Y^2] / 2 of the impulses, for a motion with E[y'] = 0. For evenly spaced
  /// kicks with a nonzero mean amplitude, the mean power has an error of first order in the kick
  /// interval.
  double power;
  /// Expected work of the impulses per unit time for any motion, where the work is the sum of (b Y
  /// - shift) v + Y^2/2 over all impulses, with the factor b(y) of parametric impulses (b = 1
  ///   without a factor). The shift in the formula of the work is 0 for Poisson impulses, since the
  ///   mean velocity at Poisson impulses is 0. For evenly spaced kicks the shift in the formula of
  ///   the work is E[Y], since the mean velocity at evenly spaced kicks is not 0.
  double shift, work;
  /// Quantile function of the amplitude law with mean 0 and width 1, for laws with
  /// AmplitudeByQuantileFunction; null for other amplitude laws
  std::shared_ptr<const PiecewiseQuantileFunction> pieces = {};
};

ImpulseProcess poisson_impulse_process(const problem::ImpulseTrain& impulses);

/// Returns an approximation of the Gaussian white noise with the mean and intensity of the
/// impulses, by kicks at the interval h with amplitudes N(lambda E[Y] h, lambda E[Y^2] h).
ImpulseProcess white_noise_impulse_process(const problem::ImpulseTrain& impulses, double interval);

/// Returns impulses at unit intervals with standard normal amplitudes, which NoiseSource and the
/// initial states use as random numbers.
ImpulseProcess standard_normal_number_process();

}  // namespace fpkcheck::mcs
