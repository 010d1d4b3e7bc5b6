#pragma once

#include <boost/random/bernoulli_distribution.hpp>
#include <boost/random/exponential_distribution.hpp>
#include <boost/random/laplace_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cstdint>
#include <variant>

#include "problem/impulse_train.hpp"

namespace fpkcheck::mcs {

/// mean - deviation or mean + deviation, by the toss of a coin.
struct TwoPointDistribution {
  double mean;
  double deviation;
  boost::random::bernoulli_distribution<double> coin{0.5};

  template <class Engine>
  double operator()(Engine& engine) {
    return coin(engine) ? mean + deviation : mean - deviation;
  }
};

/// Random numbers of one stream. Boost.Random's generators and ziggurat distributions give the same
/// numbers on every platform, which the standard library's distributions do not.
class ImpulseSource {
 public:
  /// Streams of one seed, and of different seeds, are set apart by a seed sequence over all three
  /// 32-bit words of (seed, stream).
  ImpulseSource(const problem::ImpulseTrain& impulses, std::uint64_t seed, std::uint32_t stream);

  /// Time from one impulse to the next: exponential with the mean 1/lambda.
  double waiting_time() { return waiting_(engine_); }

  /// An amplitude Y of the impulse law.
  double amplitude() {
    return std::visit([this](auto& law) { return law(engine_); }, amplitude_);
  }

  /// A standard normal number, for the initial state.
  double standard_normal() { return normal_(engine_); }

 private:
  using Amplitude = std::variant<boost::random::normal_distribution<double>,
                                 boost::random::laplace_distribution<double>, TwoPointDistribution,
                                 boost::random::uniform_real_distribution<double>>;
  static Amplitude sampler(const problem::GaussianLaw& law);
  static Amplitude sampler(const problem::LaplaceLaw& law);
  static Amplitude sampler(const problem::TwoPointLaw& law);
  static Amplitude sampler(const problem::UniformLaw& law);

  boost::random::mt19937_64 engine_;
  boost::random::exponential_distribution<double> waiting_;
  boost::random::normal_distribution<double> normal_;
  Amplitude amplitude_;
};

}  // namespace fpkcheck::mcs
