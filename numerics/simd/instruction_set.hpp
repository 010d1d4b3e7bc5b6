#pragma once

#include <vector>

namespace fpkcheck::simd {

/// Instruction sets for which the SIMD code is compiled. The processor is queried at run time: one
/// program serves all x86-64 processors, and other machines use their baseline.
enum class InstructionSet { baseline, avx2, avx512 };

/// A compiled SIMD variant: instruction set and number of lanes.
struct CodeVariant {
  InstructionSet instructions;
  int width;
};

/// The variants that this program contains and this processor supports, the fastest last.
std::vector<CodeVariant> available_variants();

/// Selects the version of a function that was compiled for an instruction set.
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
