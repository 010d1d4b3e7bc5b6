#include "mcs/impulses/noise_source.hpp"

#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::mcs {

void NoiseSource::make_impulse_block() {
  static const auto make = simd::select_variant(
      simd::available_code_variants().back().instructions, baseline::make_impulse_block,
      avx2::make_impulse_block, avx512::make_impulse_block);
  static const Excitation normal = standard_normal_impulses();
  block_ = make(normal, uniform_numbers(seed_, stream_, RandomNumberPurpose::noise, number_));
}

void NoiseSource::continue_from(std::uint64_t number) {
  number_ = number - number % kBlockSize;
  if (number_ < number) make_impulse_block();
  number_ = number;
}

}  // namespace fpkcheck::mcs
