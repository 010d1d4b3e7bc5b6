#include "mcs/impulse_source.hpp"

#include <array>
#include <boost/random/seed_seq.hpp>

namespace fpkcheck::mcs {
namespace {

boost::random::mt19937_64 engine_of(std::uint64_t seed, std::uint32_t stream) {
  const std::array<std::uint32_t, 3> words{static_cast<std::uint32_t>(seed),
                                           static_cast<std::uint32_t>(seed >> 32), stream};
  boost::random::seed_seq sequence(words.begin(), words.end());
  return boost::random::mt19937_64(sequence);
}

}  // namespace

ImpulseSource::ImpulseSource(const problem::ImpulseTrain& impulses, std::uint64_t seed,
                             std::uint32_t stream)
    : engine_(engine_of(seed, stream)),
      waiting_(impulses.arrival_rate()),
      amplitude_(std::visit([](const auto& law) { return sampler(law); }, impulses.law().kind())) {}

ImpulseSource::Amplitude ImpulseSource::sampler(const problem::GaussianLaw& law) {
  return boost::random::normal_distribution<double>(law.mean, law.deviation);
}

ImpulseSource::Amplitude ImpulseSource::sampler(const problem::LaplaceLaw& law) {
  return boost::random::laplace_distribution<double>(law.mean, law.scale);
}

ImpulseSource::Amplitude ImpulseSource::sampler(const problem::TwoPointLaw& law) {
  return TwoPointDistribution{law.mean, law.deviation};
}

ImpulseSource::Amplitude ImpulseSource::sampler(const problem::UniformLaw& law) {
  return boost::random::uniform_real_distribution<double>(law.mean - law.half_width,
                                                          law.mean + law.half_width);
}

}  // namespace fpkcheck::mcs
