#pragma once

#include <memory>

#include "mcs/impulses/amplitude_pieces.hpp"

namespace fpkcheck::problem {
class ImpulseTrain;
}

namespace fpkcheck::mcs {

/// The excitation as a sequence of impulses.
struct Excitation {
  enum class Arrivals {
    poisson,  ///< waiting times exponential with mean `interval`
    even      ///< waiting times `interval`; the first one is a random fraction of `interval`
  };

  Arrivals arrivals;
  double interval;
  int law;      ///< amplitude law, as an index of DrawnLaws
  double mean;  ///< mean amplitude
  /// Scale of the amplitude, width() of its law; negative for the mirrored law.
  double width;

  /// Mean power of the impulses, lambda E[Y^2] / 2, since E[y'] = 0. Even kicks with a mean differ
  /// by terms of first order in the interval.
  double power;
  /// `work` is the expected work sum of (Y - shift) v + Y^2/2 per unit time, for any motion.
  /// Poisson impulses act on the stationary v, whose mean is 0: shift = 0. Even kicks do not:
  /// shift = E[Y].
  double shift, work;
  /// Quantile function for mean 0 and width 1, for laws with DrawnFromPieces; else null.
  std::shared_ptr<const AmplitudePieces> pieces = {};
};

/// The Poisson impulses of the problem, paper (3).
Excitation poisson_excitation(const problem::ImpulseTrain& impulses);

/// Gaussian white noise of the same mean and intensity, as kicks at even times h with amplitudes
/// N(lambda E[Y] h, lambda E[Y^2] h).
Excitation white_excitation(const problem::ImpulseTrain& impulses, double interval);

/// Impulses with standard normal amplitudes.
Excitation standard_normal_excitation();

}  // namespace fpkcheck::mcs
