#include "numerics/simd/instruction_set.hpp"

namespace fpkcheck::simd {

std::vector<SimdVariant> available_simd_variants() {
  std::vector<SimdVariant> lanes{{InstructionSet::baseline, 1}, {InstructionSet::baseline, 2}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) lanes.push_back({InstructionSet::avx2, 4});
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    lanes.push_back({InstructionSet::avx512, 8});
  }
#endif
  return lanes;
}

}  // namespace fpkcheck::simd
