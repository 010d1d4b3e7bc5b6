#pragma once

#include <vector>

namespace fpkcheck::simd {

/// Instructions for which the lanes are compiled. Which of them a processor has is asked when the
/// program runs: one program serves all x86-64, and other machines use their baseline.
enum class InstructionSet { baseline, avx2, avx512 };

/// How trajectories are moved side by side: how many, and by what instructions.
struct LaneSet {
  InstructionSet instructions;
  int width;
};

/// What this program was compiled for and this processor can run, the fastest one last.
std::vector<LaneSet> available_lanes();

/// Of a function that was compiled for each of them, the one to call.
template <class Function>
Function* compiled_for(InstructionSet instructions, Function* baseline, Function* avx2,
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
