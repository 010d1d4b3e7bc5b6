#pragma once

#include <memory>

#include "mcs/impulses/piecewise_quantile_function.hpp"

namespace fpkcheck::problem {
class ImpulseTrain;
}

namespace fpkcheck::mcs {

/// The excitation as a sequence of impulses.
struct Excitation {
  enum class Arrivals {
    poisson,  ///< waiting times exponential with mean `interval`
    /// Waiting times `interval`; the first waiting time is a random fraction of `interval`
    even
  };

  Arrivals arrivals;
  double interval;
  int law;      ///< amplitude law, as an index of DrawnLaws
  double mean;  ///< mean amplitude
  /// Scale of the amplitude, width() of its law; negative for the mirrored law.
  double width;

  /// Mean power of the impulses, lambda E[Y^2] / 2, since E[y'] = 0. Evenly spaced kicks with a
  /// nonzero mean have a power that differs by terms of first order in the interval.
  double power;
  /// Expected work per unit time, the sum over impulses of (Y - shift) v + Y^2/2, valid for any
  /// motion. Poisson impulses meet the stationary v, whose mean is 0: shift = 0. Evenly spaced
  /// kicks meet a v with another mean: shift = E[Y].
  double shift, work;
  /// Quantile function of the law with mean 0 and width 1, for laws with DrawnFromQuantileFunction.
  /// Null for all other laws.
  std::shared_ptr<const PiecewiseQuantileFunction> pieces = {};
};

/// The Poisson impulses of the problem, paper (3).
Excitation poisson_excitation(const problem::ImpulseTrain& impulses);

/// Gaussian white noise of the same mean and intensity as the impulses, approximated by evenly
/// spaced kicks at the interval h with amplitudes N(lambda E[Y] h, lambda E[Y^2] h).
Excitation white_noise_excitation(const problem::ImpulseTrain& impulses, double interval);

/// Impulses at unit intervals with standard normal amplitudes, which NoiseSource and the initial
/// states use as random numbers.
Excitation standard_normal_impulses();

}  // namespace fpkcheck::mcs
