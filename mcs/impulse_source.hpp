#pragma once

#include <array>
#include <cstdint>

#include "problem/impulse_train.hpp"

namespace fpkcheck::mcs {

/// A term of paper (3): how long after the one before it comes, and its amplitude Y.
struct Impulse {
  double waiting;
  double amplitude;
};

/// Impulses that stand for the excitation.
struct Excitation {
  enum class Arrivals {
    poisson,  ///< waiting times exponential with mean `interval`
    even      ///< waiting times `interval`, the first one a random part of it
  };
  enum class Law { gaussian, laplace, two_point, uniform };

  Arrivals arrivals;
  double interval;
  Law law;
  double mean;   ///< of the amplitude
  double width;  ///< deviation (gaussian, two_point), scale (laplace) or half width (uniform)

  /// What the impulses bring on the average: lambda E[Y^2] / 2, as E[y'] = 0. (With a mean, even
  /// kicks bring it but for terms of first order in the interval.)
  double power;
  /// The work sum of (Y - shift) v + Y^2/2 has this expectation per unit time whatever the motion:
  /// Poisson impulses see the stationary v, whose mean is 0 (shift 0), even ones do not (shift
  /// E[Y]).
  double shift, work;
};

/// The impulses of the problem, paper (3).
Excitation poisson_excitation(const problem::ImpulseTrain& impulses);

/// Gaussian white noise of the same mean and intensity, lumped into kicks at even times:
/// amplitudes N(lambda E[Y] h, lambda E[Y^2] h).
Excitation white_excitation(const problem::ImpulseTrain& impulses, double interval);

/// Numbers in (0, 1) for a block of impulses, made of the 128 bits of one counter each: of 53, 43
/// and 32 bits. The second one decides how far out an amplitude may lie: 7.8 deviations or 30
/// scales.
struct Uniforms;

/// The impulses of one stream: impulse n is a function of (seed, stream, n) alone. Made in blocks,
/// in lanes.
class ImpulseSource {
 public:
  static constexpr int kBlock = 16;

  ImpulseSource(const Excitation& excitation, std::uint64_t seed, std::uint32_t stream)
      : excitation_(excitation), seed_(seed), stream_(stream) {}
  ImpulseSource(const problem::ImpulseTrain& impulses, std::uint64_t seed, std::uint32_t stream)
      : ImpulseSource(poisson_excitation(impulses), seed, stream) {}

  Impulse next() {
    const auto place = static_cast<std::size_t>(number_ % kBlock);
    if (place == 0) make_block();
    ++number_;
    return {waiting_[place], amplitude_[place]};
  }

  /// How many have been given out.
  std::uint64_t number() const { return number_; }
  /// Continues as if `number` had been given out.
  void continue_from(std::uint64_t number);

  /// Two independent standard normal numbers, for the initial state: always the same ones.
  std::array<double, 2> standard_normals() const;

 private:
  void make_block();

  Excitation excitation_;
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t number_ = 0;
  std::array<double, kBlock> waiting_{}, amplitude_{};
};

struct Uniforms {
  std::array<double, ImpulseSource::kBlock> first, second, third;
};

}  // namespace fpkcheck::mcs
