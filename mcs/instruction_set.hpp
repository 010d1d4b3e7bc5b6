#pragma once

#include <vector>

namespace fpkcheck::mcs {

struct Excitation;
struct Motion;
struct Stream;
struct Uniforms;

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

// The same functions, compiled for each of them.
namespace baseline {
void move(const Motion& motion, Stream* const* streams, int width);
void make_impulses(const Excitation& excitation, const Uniforms& uniforms, double* waiting,
                   double* amplitude);
}  // namespace baseline
namespace avx2 {
void move(const Motion& motion, Stream* const* streams, int width);
void make_impulses(const Excitation& excitation, const Uniforms& uniforms, double* waiting,
                   double* amplitude);
}  // namespace avx2
namespace avx512 {
void move(const Motion& motion, Stream* const* streams, int width);
void make_impulses(const Excitation& excitation, const Uniforms& uniforms, double* waiting,
                   double* amplitude);
}  // namespace avx512

}  // namespace fpkcheck::mcs
