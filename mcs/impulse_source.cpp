#include "mcs/impulse_source.hpp"

#include <cmath>
#include <utility>

#include "mcs/counter_random.hpp"
#include "mcs/instruction_set.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kBlock = ImpulseSource::kBlock;
Uniforms uniforms(std::uint64_t seed, std::uint32_t stream, Purpose purpose, std::uint64_t from) {
  Uniforms u;
  for (std::uint64_t k = 0; k < kBlock; ++k) {
    const auto bits = random_bits(seed, stream, purpose, from + k);
    const std::uint64_t word = std::uint64_t{bits[0]} << 32 | bits[1];
    const std::uint64_t rest = std::uint64_t{bits[2]} << 11 | (word & 0x7ff);
    u.first[k] = (static_cast<double>(word >> 11) + 0.5) * 0x1p-53;
    u.second[k] = (static_cast<double>(rest) + 0.5) * 0x1p-43;
    u.third[k] = (static_cast<double>(bits[3]) + 0.5) * 0x1p-32;
  }
  return u;
}

using Make = void (*)(const Excitation&, const Uniforms&, double*, double*);
Make best() {
  switch (available_lanes().back().instructions) {
    case InstructionSet::avx512:
      return avx512::make_impulses;
    case InstructionSet::avx2:
      return avx2::make_impulses;
    case InstructionSet::baseline:
      break;
  }
  return baseline::make_impulses;
}

struct LawOf {
  using Law = Excitation::Law;
  std::pair<Law, double> operator()(const problem::GaussianLaw& law) const {
    return {Law::gaussian, law.deviation};
  }
  std::pair<Law, double> operator()(const problem::LaplaceLaw& law) const {
    return {Law::laplace, law.scale};
  }
  std::pair<Law, double> operator()(const problem::TwoPointLaw& law) const {
    return {Law::two_point, law.deviation};
  }
  std::pair<Law, double> operator()(const problem::UniformLaw& law) const {
    return {Law::uniform, law.half_width};
  }
};

}  // namespace

Excitation poisson_excitation(const problem::ImpulseTrain& impulses) {
  const auto [law, width] = std::visit(LawOf{}, impulses.law().kind());
  return {.arrivals = Excitation::Arrivals::poisson,
          .interval = 1 / impulses.arrival_rate(),
          .law = law,
          .mean = impulses.law().mean(),
          .width = width,
          .power = impulses.intensity() / 2,
          .shift = 0,
          .work = impulses.intensity() / 2};
}

Excitation white_excitation(const problem::ImpulseTrain& impulses, double interval) {
  const double mean = impulses.rate_moment(1) * interval;
  const double variance = impulses.intensity() * interval;
  return {.arrivals = Excitation::Arrivals::even,
          .interval = interval,
          .law = Excitation::Law::gaussian,
          .mean = mean,
          .width = std::sqrt(variance),
          .power = impulses.intensity() / 2,
          .shift = mean,
          .work = (variance + mean * mean) / (2 * interval)};
}

void ImpulseSource::make_block() {
  static const Make make = best();
  const Uniforms u = uniforms(seed_, stream_, Purpose::impulses, number_);
  make(excitation_, u, waiting_.data(), amplitude_.data());
  if (number_ == 0 && excitation_.arrivals == Excitation::Arrivals::even) {
    waiting_[0] = u.first[0] * excitation_.interval;
  }
}

void ImpulseSource::continue_from(std::uint64_t number) {
  number_ = number - number % kBlock;
  if (number_ < number) make_block();
  number_ = number;
}

std::array<double, 2> ImpulseSource::standard_normals() const {
  const Uniforms u = uniforms(seed_, stream_, Purpose::start, 0);
  // As standard amplitudes of a Gaussian law.
  const Excitation normal{.arrivals = Excitation::Arrivals::poisson,
                          .interval = 1,
                          .law = Excitation::Law::gaussian,
                          .mean = 0,
                          .width = 1,
                          .power = 0.5,
                          .shift = 0,
                          .work = 0.5};
  std::array<double, kBlock> waiting, amplitude;
  baseline::make_impulses(normal, u, waiting.data(), amplitude.data());
  return {amplitude[0], amplitude[1]};
}

}  // namespace fpkcheck::mcs
