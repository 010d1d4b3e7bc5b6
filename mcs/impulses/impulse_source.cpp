#include "mcs/impulses/impulse_source.hpp"

#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {
namespace {

ImpulseBlock draw_block_with_widest_simd(const ImpulseProcess& excitation,
                                         const UniformRandomNumbers& uniforms) {
  static const auto make = simd::select_variant(
      simd::available_simd_variants().back().instructions, baseline::make_impulse_block,
      avx2::make_impulse_block, avx512::make_impulse_block);
  return make(excitation, uniforms);
}

}  // namespace

void ImpulseSource::draw_next_block() {
  const UniformRandomNumbers u = uniform_random_numbers(seed_, stream_, purpose_, number_);
  block_ = draw_block_with_widest_simd(excitation_, u);
  if (number_ == 0 && excitation_.arrivals == ImpulseProcess::Arrivals::even) {
    block_.waiting_time[0] = u.first[0] * excitation_.interval;
  }
}

void ImpulseSource::seek_to_impulse(std::uint64_t number) {
  number_ = number - number % kImpulsesPerBlock;
  if (number_ < number) draw_next_block();
  number_ = number;
}

std::array<double, 2> ImpulseSource::initial_standard_normals() const {
  static const ImpulseProcess normal = standard_normal_number_process();
  const ImpulseBlock block = baseline::make_impulse_block(
      normal, uniform_random_numbers(seed_, stream_, RandomNumberPurpose::start, 0));
  return {block.amplitude[0], block.amplitude[1]};
}

}  // namespace fpkcheck::mcs
