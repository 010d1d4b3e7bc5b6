#pragma once

#include <array>
#include <cstdint>

#include "mcs/impulses/excitation.hpp"
#include "mcs/impulses/uniform_numbers.hpp"

namespace fpkcheck::mcs {

struct ImpulseBlock {
  std::array<double, kImpulsesPerBlock> waiting_time{}, amplitude{};
};

// The source code of make_impulse_block() is compiled for three instruction sets.
namespace baseline {
ImpulseBlock make_impulse_block(const ImpulseProcess& excitation,
                                const UniformRandomNumbers& uniforms);
}
namespace avx2 {
ImpulseBlock make_impulse_block(const ImpulseProcess& excitation,
                                const UniformRandomNumbers& uniforms);
}
namespace avx512 {
ImpulseBlock make_impulse_block(const ImpulseProcess& excitation,
                                const UniformRandomNumbers& uniforms);
}

/// Impulse of paper (3): waiting time after the previous impulse, and amplitude Y.
struct Impulse {
  double waiting_time;
  double amplitude;
};

/// Generator of the impulses of one trajectory stream; impulse n depends only on (seed, stream, n).
class ImpulseSource {
 public:
  ImpulseSource(const ImpulseProcess& excitation, std::uint64_t seed, std::uint32_t stream,
                RandomNumberPurpose purpose = RandomNumberPurpose::impulses)
      : excitation_(excitation), seed_(seed), stream_(stream), purpose_(purpose) {}
  ImpulseSource(const problem::ImpulseTrain& impulses, std::uint64_t seed, std::uint32_t stream)
      : ImpulseSource(poisson_impulse_process(impulses), seed, stream) {}

  Impulse next_impulse() {
    const auto index = static_cast<std::size_t>(number_ % kImpulsesPerBlock);
    if (index == 0) draw_next_block();
    ++number_;
    return {block_.waiting_time[index], block_.amplitude[index]};
  }

  std::uint64_t drawn_impulse_count() const { return number_; }
  /// Sets the impulse generator to the state after `number` drawn impulses.
  void seek_to_impulse(std::uint64_t number);

  /// Returns two independent standard normal numbers for the initial state of the trajectory
  /// stream; all calls return the same numbers.
  std::array<double, 2> initial_standard_normals() const;

 private:
  void draw_next_block();

  ImpulseProcess excitation_;
  std::uint64_t seed_;
  std::uint32_t stream_;
  RandomNumberPurpose purpose_;
  std::uint64_t number_ = 0;
  ImpulseBlock block_{};
};

/// Generator of standard normal random numbers of one trajectory stream, for Gaussian noise.
class NoiseSource {
 public:
  NoiseSource(std::uint64_t seed, std::uint32_t stream)
      : impulses_(standard_normal_number_process(), seed, stream, RandomNumberPurpose::noise) {}

  double next_normal() { return impulses_.next_impulse().amplitude; }

  std::uint64_t drawn_number_count() const { return impulses_.drawn_impulse_count(); }
  void seek_to_number(std::uint64_t number) { impulses_.seek_to_impulse(number); }

 private:
  ImpulseSource impulses_;
};

}  // namespace fpkcheck::mcs
