#pragma once

#include <vector>

namespace fpkcheck::simd {

/// Instruction sets for which the SIMD code is compiled. The program queries the processor at run
/// time, so that the same executable runs on all x86-64 processors. On processor architectures
/// other than x86-64 the program uses the baseline instruction set.
enum class InstructionSet { baseline, avx2, avx512 };

struct SimdVariant {
  InstructionSet instructions;
  int width;
};

/// Returns the variants of the SIMD code that this processor supports, the fastest variant last.
std::vector<SimdVariant> available_simd_variants();

template <class Function>
Function* select_variant(InstructionSet instructions, Function* baseline, Function* avx2,
                         Function* avx512) {
  switch (instructions) {
    case InstructionSet::avx512:
      return avx512;
    case InstructionSet::avx2:
      return avx2;
    case InstructionSet::baseline:
      break;
  }
  return baseline;
}

}  // namespace fpkcheck::simd
