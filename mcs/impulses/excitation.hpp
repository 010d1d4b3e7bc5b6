#pragma once

#include <memory>

#include "mcs/impulses/amplitude_pieces.hpp"

namespace fpkcheck::problem {
class ImpulseTrain;
}

namespace fpkcheck::mcs {

/// Impulses that stand for the excitation.
struct Excitation {
  enum class Arrivals {
    poisson,  ///< waiting times exponential with mean `interval`
    even      ///< waiting times `interval`, the first one a random part of it
  };

  Arrivals arrivals;
  double interval;
  int law;      ///< of the amplitude: its place in DrawnLaws
  double mean;  ///< of the amplitude
  /// Of the amplitude, what its law has as width(): negative where its mirror image is drawn.
  double width;

  /// What the impulses bring on the average: lambda E[Y^2] / 2, as E[y'] = 0. (With a mean, even
  /// kicks bring it but for terms of first order in the interval.)
  double power;
  /// The work sum of (Y - shift) v + Y^2/2 has this expectation per unit time whatever the motion:
  /// Poisson impulses see the stationary v, whose mean is 0 (shift 0), even ones do not (shift
  /// E[Y]).
  double shift, work;
  /// Of mean 0 and width 1, where the law is drawn from pieces (DrawnFromPieces).
  std::shared_ptr<const AmplitudePieces> pieces = {};
};

/// The impulses of the problem, paper (3).
Excitation poisson_excitation(const problem::ImpulseTrain& impulses);

/// Gaussian white noise of the same mean and intensity, lumped into kicks at even times:
/// amplitudes N(lambda E[Y] h, lambda E[Y^2] h).
Excitation white_excitation(const problem::ImpulseTrain& impulses, double interval);

/// Impulses whose amplitudes are standard normal.
Excitation standard_normal_excitation();

}  // namespace fpkcheck::mcs
